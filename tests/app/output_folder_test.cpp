// The folder of results: complete files or none, whatever happens on the way.

#include <algorithm>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/virtual_weights.h"

namespace pliant::test {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;
using ::testing::UnorderedElementsAreArray;

TEST(OutputFolder, WithSomethingElseInItIsRefused) {
  const MeasuredFolder folder;
  folder.write("thesis/chapter1.tex", "mine");
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("thesis")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("chapter1.tex")));
  EXPECT_THAT(names_in(folder.path() / "thesis"), ElementsAre("chapter1.tex"));
}

TEST(OutputFolder, OfAnotherCommandIsRefused) {
  const MeasuredFolder folder;
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("study")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(names_in(folder.path() / "study"), Contains("weights.csv"));
}

TEST(OutputFolder, WithEarlierResultsIsReplacedAsAWhole) {
  const MeasuredFolder folder;
  EXPECT_EQ(run_program({"fit", folder.study(), "-o", folder.file("fit")}).status, 0);
  // The next study calls its experiment something else: the earlier prediction must go.
  std::string study = content_of(folder.study());
  const size_t name = study.find("weights", study.find("- name"));
  study.replace(name, std::string("weights").size(), "hung");
  folder.write("study/study.yaml", study);
  EXPECT_EQ(run_program({"fit", folder.study(), "-o", folder.file("fit")}).status, 0);
  EXPECT_THAT(names_in(folder.path() / "fit" / "predictions"), ElementsAre("hung.csv"));
}

TEST(OutputFolder, KeepsEarlierResultsWhenANewFitFails) {
  const MeasuredFolder folder;
  run_program({"fit", folder.study(), "-o", folder.file("fit")});
  const auto before = names_in(folder.path() / "fit");
  const std::string material = content_of(folder.file("fit/material.json"));
  folder.write("study/weights.csv", "weight_N,length_mm\n1,x\n");
  EXPECT_EQ(run_program({"fit", folder.study(), "-o", folder.file("fit")}).status, 2);
  EXPECT_THAT(names_in(folder.path() / "fit"), UnorderedElementsAreArray(before));
  EXPECT_EQ(content_of(folder.file("fit/material.json")), material);
}

TEST(OutputFolder, ThatIsAFileIsRefused) {
  const MeasuredFolder folder;
  folder.write("fit", "a file");
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("fit")});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(content_of(folder.file("fit")), "a file");
}

// Root may write everywhere: the program is run as somebody else then.
void become_nobody() {
  constexpr uid_t kNobody = 65534;
  if (geteuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(125);
}

TEST(OutputFolder, ThatCannotBeWrittenToIsRefusedBeforeAnyWork) {
  const MeasuredFolder folder;
  const auto locked = folder.path() / "locked";
  std::filesystem::create_directory(locked);
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
  std::filesystem::permissions(locked, std::filesystem::perms(0555));
  const ProgramRun run =
      run_program({"fit", folder.study(), "-o", locked.string()}, {.in_child = become_nobody});
  if (run.status == 125 || run.status == 127) GTEST_SKIP() << "cannot become another user";
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("locked")));
  EXPECT_THAT(names_in(locked), IsEmpty());
}

// Files may grow to 20 kB: enough for the tables, not for the report. A full disk fails the same
// write.
TEST(OutputFolder, IsLeftAsItWasWhenTheDiskIsFull) {
  const MeasuredFolder folder;
  const ProgramRun run =
      run_program({"fit", folder.study(), "-o", folder.file("deep/fit")}, {.in_child = [] {
                    const rlimit limit{20000, 20000};
                    setrlimit(RLIMIT_FSIZE, &limit);
                  }});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("report.html"),
                                     AnyOf(HasSubstr("File too large"), HasSubstr("No space"))));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "deep"));
}

/// A lab whose study takes minutes to fit with everything asked for.
std::string long_work_lab() {
  return "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
         "/materials/spandex.json\nspecimens: 4\n"
         "experiments:\n"
         "  - {name: cycles, type: tensile-cycles, direction: warp, samples: 5000,\n"
         "     peaks: [2 %, 4 %, 6 %, 8 %, 10 %, 20 %], noise: {force: 5 mN}}\n";
}

// The program is a second or so into its work, and has a second to end.
TEST(Interrupt, EndsALongFitWithinASecondAndLeavesWhatGoesOn) {
  const MeasuredFolder folder(long_work_lab());
  constexpr double kWait = kSanitizerFactor;
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("deep/fit"),
                                      "--compare", "friction", "--profile", "*"},
                                     {.interrupt_after = kWait});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_LT(run.seconds, kWait + kSanitizerFactor);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("interrupted")));
  EXPECT_THAT(names_in(folder.path() / "deep" / "fit"),
              UnorderedElementsAre(".pliant-results.json", "progress.bin"));
}

TEST(SlowInterrupt, LeavesEarlierResultsAsTheyWere) {
  const MeasuredFolder folder(long_work_lab());
  const MeasuredFolder quick;
  EXPECT_EQ(run_program({"fit", quick.study(), "-o", folder.file("fit")}).status, 0);
  auto expected = names_in(folder.path() / "fit");
  expected.push_back("progress.bin");
  const ProgramRun run = run_program(
      {"fit", folder.study(), "-o", folder.file("fit"), "--compare", "friction", "--profile", "*"},
      {.interrupt_after = 0.7 * kSanitizerFactor});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(names_in(folder.path() / "fit"), UnorderedElementsAreArray(expected));
}

}  // namespace
}  // namespace pliant::test
