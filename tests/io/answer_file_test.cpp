#include "pliant/io/answer_file.h"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;

using Numbers = Journal::Numbers;

class AnswerFileInFolder : public ::testing::Test {
 protected:
  AnswerFile begun() const {
    return {file(), [this](const std::string& bytes) { folder_.write("progress.bin", bytes); }};
  }
  std::unique_ptr<AnswerFile> resumed() const {
    auto answers = std::make_unique<AnswerFile>(file(), nullptr);
    answers->resume();
    return answers;
  }
  void write_some() const {
    AnswerFile answers = begun();
    for (const auto& [question, answer] : some_) answers.answer(question, [&] { return answer; });
    EXPECT_TRUE(answers.save());
  }
  /// How many of the answers had to be worked out.
  int worked_out(AnswerFile& answers) const {
    int works = 0;
    for (const auto& [question, answer] : some_) {
      const Numbers found = answers.answer(question, [&] {
        ++works;
        return answer;
      });
      EXPECT_EQ(found, answer) << question;
    }
    return works;
  }
  std::filesystem::path file() const { return folder_.path() / "progress.bin"; }

  const TemporaryFolder folder_;
  const std::vector<std::pair<std::string, Numbers>> some_{
      {"first", {0.1, 1.0 / 3, std::numeric_limits<double>::denorm_min()}},
      {"of two\nlines", {}},
      {"last", {INFINITY, -0.0}}};
};

TEST_F(AnswerFileInFolder, GivesEveryAnswerBack) {
  write_some();
  EXPECT_EQ(worked_out(*resumed()), 0);
  EXPECT_EQ(AnswerFile::count(file()), 3);
  EXPECT_TRUE(is_answer_file(file()));
}

TEST_F(AnswerFileInFolder, GoesOnBeforeAnAnswerThatWasCutOff) {
  write_some();
  const auto whole = std::filesystem::file_size(file());
  for (const int cut : {1, 10, 40}) {
    std::filesystem::resize_file(file(), whole - static_cast<std::uintmax_t>(cut));
    const auto answers = resumed();
    EXPECT_EQ(worked_out(*answers), 1) << cut;
    answers->save();
    EXPECT_EQ(std::filesystem::file_size(file()), whole);
    EXPECT_EQ(worked_out(*resumed()), 0) << cut;
  }
}

TEST_F(AnswerFileInFolder, LeavesNoFileBeforeThereIsAnAnswer) {
  AnswerFile answers = begun();
  EXPECT_FALSE(answers.save());
  EXPECT_FALSE(std::filesystem::exists(file()));
}

TEST_F(AnswerFileInFolder, RefusesOtherQuestionsAndOtherFiles) {
  write_some();
  const auto answers = resumed();
  const InputError other =
      input_error_of([&] { answers->answer("second", [] { return Numbers{}; }); });
  EXPECT_EQ(other.problem(), "is the progress of a run with other data, settings or version");
  EXPECT_FALSE(answers->is_begun());
  folder_.write("progress.bin", "pliant: progress/1\n");
  EXPECT_EQ(input_error_of([&] { resumed(); }).problem(), "is no progress of such a run");
  EXPECT_FALSE(is_answer_file(file()));
  std::filesystem::remove(file());
  EXPECT_EQ(input_error_of([&] { resumed(); }).problem(),
            "is not there: nothing was stopped that could go on");
}

}  // namespace
}  // namespace pliant
