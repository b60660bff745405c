#include "pliant/io/atomic_file.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "input_error_of.h"
#include "limited_process.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::content_of;
using test::FileSizeLimit;
using test::input_error_of;
using test::TemporaryFolder;

int files_in(const std::filesystem::path& folder) {
  using Entries = std::filesystem::directory_iterator;
  return static_cast<int>(std::distance(Entries(folder), Entries()));
}

TEST(WriteFileAtomically, ReplacesAFileAsAWhole) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("a", "old");
  write_file_atomically(file, "new");
  EXPECT_EQ(content_of(file), "new");
  {
    const FileSizeLimit limit(1000);
    EXPECT_THROW(write_file_atomically(file, std::string(5000, 'x')), OutputError);
  }
  EXPECT_EQ(content_of(file), "new");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(WriteFileAtomically, RefusesPlacesWhereNothingCanBeCreated) {
  const TemporaryFolder folder;
  EXPECT_EQ(input_error_of([&] { write_file_atomically(folder.path() / "no/a", "1"); }).problem(),
            "cannot be created: No such file or directory");
  input_error_of([&] { write_file_atomically(folder.path(), "1"); });
  EXPECT_EQ(files_in(folder.path()), 0);
}

}  // namespace
}  // namespace pliant
