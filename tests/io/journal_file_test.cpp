#include "pliant/io/journal_file.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;

Journal::Content some_content() {
  const double least = std::numeric_limits<double>::denorm_min();
  return {{{"search of shear", {0.1, 1.0 / 3, least}}, {"cost", {INFINITY}}},
          {-0.0, 7},
          {{"a", {}}, {"b", {1e300}}},
          {{"weft", {{"search", {1, -2}}}}, {"warp", {}}}};
}

void expect_same(const std::vector<Journal::Entry>& found,
                 const std::vector<Journal::Entry>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].question, expected[i].question);
    EXPECT_EQ(found[i].answer, expected[i].answer);
  }
}

TEST(JournalFile, GivesEveryNumberBack) {
  const TemporaryFolder folder;
  const Journal::Content content = some_content();
  folder.write("progress.bin", journal_bytes(content));
  const Journal::Content found = read_journal(folder.path() / "progress.bin");
  expect_same(found.entries, content.entries);
  EXPECT_EQ(found.reached, content.reached);
  EXPECT_EQ(found.kept, content.kept);
  ASSERT_EQ(found.parts.size(), content.parts.size());
  for (const auto& [name, entries] : content.parts) expect_same(found.parts.at(name), entries);
}

TEST(JournalFile, IsRefusedWhereItIsDamagedOrSomethingElse) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "progress.bin";
  const auto refusal_of = [&](const std::string& bytes) {
    folder.write("progress.bin", bytes);
    return input_error_of([&] { read_journal(file); }).problem();
  };
  std::string bytes = journal_bytes(some_content());
  bytes.back() ^= 1;
  EXPECT_EQ(refusal_of(bytes), "is a damaged progress of a fit");
  EXPECT_EQ(refusal_of(bytes.substr(0, bytes.size() / 2)), "is a damaged progress of a fit");
  EXPECT_EQ(refusal_of("pliant: checkpoint/1 "), "is no progress of a fit");
  EXPECT_EQ(refusal_of(""), "is no progress of a fit");
}

}  // namespace
}  // namespace pliant
