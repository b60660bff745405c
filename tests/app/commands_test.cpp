// The program as a user runs it: its commands from end to end.

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/virtual_weights.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

bool is_one_json_object(const std::string& text) {
  return json::accept(text) && json::parse(text).is_object();
}

TEST(Help, OfTheProgramNamesTheCommandsThatWork) {
  const ProgramRun run = run_program({"--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  for (const char* command :
       {"init", "import", "fit", "evaluate", "lab", "report", "convert", "info"}) {
    EXPECT_THAT(run.out, HasSubstr(std::string("\n  ") + command + " ")) << command;
  }
  EXPECT_THAT(run.out, HasSubstr("Exit status"));
}

TEST(SlowHelp, OfEachCommandNamesItsOptions) {
  for (const char* command :
       {"init", "import", "fit", "evaluate", "lab", "report", "convert", "info"}) {
    const ProgramRun run = run_program({command, "--help"});
    EXPECT_EQ(run.status, 0) << command;
    for (const char* option : {"--threads", "--seed", "--quiet", "--log-level", "--json"}) {
      EXPECT_THAT(run.out, HasSubstr(option)) << command;
    }
  }
}

TEST(SlowUsage, ThatIsWrongHasStatusTwoAndOneLine) {
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"fitt"},
      {"fit"},
      {"fit", "a.yaml"},
      {"fit", "a.yaml", "-o", "d", "--unknown"},
      {"lab", "a.yaml", "-o", "d", "--threads", "none"}};
  for (const auto& arguments : wrong) {
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.status, 2);
    EXPECT_THAT(run.err, AllOf(StartsWith("error: "), HasSubstr("--help")));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

TEST(Lab, MakesAStudyThatFitReads) {
  const MeasuredFolder folder;
  EXPECT_EQ(folder.made.status, 0) << folder.made.err;
  EXPECT_THAT(names_in(folder.path() / "study"),
              IsSupersetOf({"study.yaml", "weights.csv", "truth.json"}));
  const ProgramRun fit = run_program({"fit", folder.study(), "-o", folder.file("fit")});
  EXPECT_EQ(fit.status, 0) << fit.err;
  EXPECT_THAT(names_in(folder.path() / "fit"),
              IsSupersetOf({"material.json", "fit.json", "study.resolved.yaml", "report.html",
                            "parameters.csv", "curves.csv", "figures.csv", "predictions"}));
  EXPECT_THAT(fit.err, AllOf(HasSubstr("stretch.warp.friction.tau"), HasSubstr("report.html")));
  EXPECT_EQ(fit.out, "");
}

TEST(Lab, IsTheSameForTheSameSeed) {
  const MeasuredFolder folder;
  const std::string lab = folder.file("lab.yaml");
  run_program({"lab", lab, "-o", folder.file("again")});
  run_program({"lab", lab, "-o", folder.file("other"), "--seed", "7"});
  const std::string first = content_of(folder.file("study/weights.csv"));
  EXPECT_EQ(content_of(folder.file("again/weights.csv")), first);
  EXPECT_NE(content_of(folder.file("other/weights.csv")), first);
}

TEST(Fit, TheResolvedStudyGivesTheSameMaterial) {
  const MeasuredFolder folder;
  run_program({"fit", folder.study(), "-o", folder.file("fit")});
  const ProgramRun again =
      run_program({"fit", folder.file("fit/study.resolved.yaml"), "-o", folder.file("again")});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(content_of(folder.file("again/parameters.csv")),
            content_of(folder.file("fit/parameters.csv")));
}

TEST(Fit, JsonIsOneObjectOnStandardOutputAndNothingElse) {
  const MeasuredFolder folder;
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("fit"), "--json"});
  EXPECT_TRUE(is_one_json_object(run.out));
  EXPECT_EQ(json::parse(run.out), json::parse(content_of(folder.file("fit/fit.json"))));
}

TEST(Fit, JsonOfSeveralStudiesIsOneObjectToo) {
  const MeasuredFolder folder;
  const std::string second = folder.write("study/second.yaml", content_of(folder.study())).string();
  const ProgramRun run =
      run_program({"fit", folder.study(), second, "-o", folder.file("fits"), "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(is_one_json_object(run.out));
}

TEST(Commands, AllPrintOneJsonObjectWhenAsked) {
  const MeasuredFolder folder;
  run_program({"fit", folder.study(), "-o", folder.file("fit")});
  const std::vector<std::vector<std::string>> commands{
      {"lab", folder.file("lab.yaml"), "-o", folder.file("lab")},
      {"init", "hanging-weights", "-o", folder.file("init")},
      {"evaluate", folder.study(), "-m", folder.file("fit/material.json"), "-o", folder.file("e")},
      {"report", folder.file("fit")},
      {"info", folder.study()}};
  for (std::vector<std::string> arguments : commands) {
    arguments.push_back("--json");
    const ProgramRun run = run_program(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(is_one_json_object(run.out)) << arguments[0] << " printed \"" << run.out << "\"";
  }
}

TEST(Fit, QuietSaysNothingOfWorkThatWentWell) {
  const MeasuredFolder folder;
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("fit"), "--quiet"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "");
}

TEST(Fit, SeveralStudiesGetAFolderEach) {
  const MeasuredFolder folder;
  const std::string a = folder.write("study/a.yaml", content_of(folder.study())).string();
  const std::string b = folder.write("study/b.yaml", content_of(folder.study())).string();
  const ProgramRun run = run_program({"fit", a, b, "-o", folder.file("fits")});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(names_in(folder.path() / "fits"), UnorderedElementsAre("a", "b"));
  EXPECT_EQ(content_of(folder.file("fits/a/parameters.csv")),
            content_of(folder.file("fits/b/parameters.csv")));
}

TEST(Fit, StudiesWhoseFoldersHaveOneNameAreRefusedBeforeAnyWork) {
  const MeasuredFolder folder;
  folder.write("more/study/study.yaml", content_of(folder.study()));
  folder.write("more/study/weights.csv", content_of(folder.file("study/weights.csv")));
  const ProgramRun run = run_program(
      {"fit", folder.study(), folder.file("more/study/study.yaml"), "-o", folder.file("fits")});
  EXPECT_EQ(run.status, 2) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "fits"));
}

TEST(Report, IsRewrittenByteForByte) {
  const MeasuredFolder folder;
  run_program({"fit", folder.study(), "-o", folder.file("fit")});
  const std::string before = content_of(folder.file("fit/report.html"));
  EXPECT_THAT(before, AllOf(StartsWith("<!DOCTYPE html>"), HasSubstr("stretch.warp.k1")));
  std::filesystem::remove(folder.file("fit/report.html"));
  const ProgramRun run = run_program({"report", folder.file("fit")});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(content_of(folder.file("fit/report.html")), before);
}

TEST(Evaluate, GivesTheErrorsOfTheFit) {
  const MeasuredFolder folder;
  run_program({"fit", folder.study(), "-o", folder.file("fit")});
  const ProgramRun run =
      run_program({"evaluate", folder.study(), "-m", folder.file("fit/material.json"), "-o",
                   folder.file("check"), "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  const json fit = json::parse(content_of(folder.file("fit/fit.json")));
  const json evaluation = json::parse(run.out);
  // The material file keeps all bits, and hanging weights have no nuisance parameter.
  EXPECT_EQ(evaluation["experiments"][0]["rms_position_mm"],
            fit["experiments"][0]["rms_position_mm"]);
  EXPECT_THAT(
      names_in(folder.path() / "check"),
      IsSupersetOf({"evaluation.json", "report.html", "predictions", "study.resolved.yaml"}));
}

TEST(SlowInit, MakesTestsThatFitReads) {
  for (const char* test :
       {"hanging-weights", "tensile-cycles", "lateral-contraction", "shear-cycles", "pure-bending",
        "cantilever", "rolled-strip", "bending-length", "buckling-bend"}) {
    const TemporaryFolder folder;
    const std::string made = (folder.path() / "mine").string();
    const ProgramRun init = run_program({"init", test, "-o", made});
    EXPECT_EQ(init.status, 0) << init.err;
    EXPECT_THAT(names_in(made), IsSupersetOf({"study.yaml", "PROTOCOL.md"}));
    const ProgramRun fit =
        run_program({"fit", made + "/study.yaml", "-o", (folder.path() / "fit").string()});
    EXPECT_EQ(fit.status, 0) << test << ": " << fit.err;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "fit" / "report.html"));
  }
}

TEST(Init, NeverReplacesFilesThatWereEdited) {
  const TemporaryFolder folder;
  const std::string made = (folder.path() / "mine").string();
  run_program({"init", "hanging-weights", "-o", made});
  folder.write("mine/study.yaml", "mine");
  EXPECT_EQ(run_program({"init", "hanging-weights", "-o", made}).status, 2);
  EXPECT_EQ(content_of(folder.path() / "mine" / "study.yaml"), "mine");
}

TEST(Fit, MayBeAskedForTheAnchorEstimatorAndProfilesAndComparison) {
  const MeasuredFolder folder;
  const ProgramRun run = run_program({"fit", folder.study(), "-o", folder.file("fit"), "--profile",
                                      "*.tau", "--compare", "friction", "--json"});
  EXPECT_EQ(json::parse(run.out)["profiles"].size(), 1u);
  EXPECT_EQ(json::parse(run.out)["models"].size(), 4u);
  const ProgramRun anchor = run_program(
      {"fit", folder.study(), "-o", folder.file("anchor"), "--estimator", "anchor", "--json"});
  EXPECT_EQ(json::parse(anchor.out)["estimator"], "anchor");
}

TEST(Fit, AProfileThatMatchesNoParameterIsAnError) {
  const MeasuredFolder folder;
  const ProgramRun run =
      run_program({"fit", folder.study(), "-o", folder.file("fit"), "--profile", "stretch.warp.t"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("stretch.warp.t")));
}

TEST(Fit, OfASolidRefusesWhatItWouldNotHeed) {
  const TemporaryFolder folder;
  const std::string made = (folder.path() / "rubber").string();
  ASSERT_EQ(run_program({"init", "homogeneous", "-o", made}).status, 0);
  const auto refused = [&](const std::string& option, const std::string& value) {
    const ProgramRun run =
        run_program({"fit", made, "-o", (folder.path() / "fit").string(), option, value});
    EXPECT_EQ(run.status, 2) << run.err;
    return run.last_line();
  };
  EXPECT_THAT(refused("--profile", "*"), StartsWith("error: --profile: "));
  EXPECT_THAT(refused("--compare", "friction"), StartsWith("error: --compare: "));
}

TEST(Version, IsPrinted) {
  const ProgramRun run = run_program({"--version"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.out, StartsWith("pliant "));
}

}  // namespace
}  // namespace pliant::test
