// What the program does with solids: templates, virtual measurements, fits, predictions, reports.

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/run_program.h"

namespace pliant::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string in(const TemporaryFolder& folder, const std::string& name) {
  return (folder.path() / name).string();
}

ProgramRun done(const std::vector<std::string>& arguments) {
  ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  return run;
}

TEST(SlowSolidProgram, FitsWhatItsTemplateHolds) {
  const TemporaryFolder folder;
  done({"init", "homogeneous", "-o", in(folder, "study")});
  const ProgramRun run =
      done({"fit", in(folder, "study/study.yaml"), "-o", in(folder, "fit"), "--json"});
  const auto fit = nlohmann::json::parse(run.out);
  for (const auto& e : fit["experiments"]) EXPECT_GT(e["r_squared"].get<double>(), 0.99);
  for (const char* file :
       {"fit/material.json", "fit/report.html", "fit/predictions/planar.csv", "fit/curves.csv"}) {
    EXPECT_TRUE(fs::exists(folder.path() / file)) << file;
  }
  EXPECT_THAT(done({"info", in(folder, "study/study.yaml")}).out, HasSubstr("law additive"));
  EXPECT_THAT(done({"info", in(folder, "fit/material.json")}).out, HasSubstr("over its range"));
  done({"report", in(folder, "fit")});
  const std::string report = content_of(folder.path() / "fit/report.html");
  EXPECT_THAT(report, HasSubstr("950.0 kg/m³"));
  EXPECT_THAT(report, ::testing::Not(HasSubstr("friction of .")));
  done({"evaluate", in(folder, "study/study.yaml"), "-m", in(folder, "fit/material.json"), "-o",
        in(folder, "evaluation")});
  EXPECT_TRUE(fs::exists(folder.path() / "evaluation/report.html"));
}

/// Fewer rows of the example, from the first touch on, and the volume's stiffness as it asks for:
/// deeper takes a minute.
void press_less(const TemporaryFolder& folder) {
  std::string table = content_of(folder.path() / "study/indentation.csv");
  table.erase(table.find("\n1.500,") + 1);
  folder.write("study/indentation.csv", table);
  std::string study = content_of(folder.path() / "study/study.yaml");
  const std::string fixed = "# fit: {fix: {J.k:";
  study.replace(study.find(fixed), fixed.size(), fixed.substr(2));
  folder.write("study/study.yaml", study);
}

// What each kind of test on a body begins with leads to a material, its report and a prediction.
TEST(SlowSolidProgram, FitsTheStudyThatEachTestOfABodyBeginsWith) {
  for (const char* kind : {"indentation", "moved-body"}) {
    const TemporaryFolder folder;
    done({"init", kind, "-o", in(folder, "study")});
    if (kind == std::string("indentation")) press_less(folder);
    EXPECT_THAT(done({"info", in(folder, "study/study.yaml")}).out, HasSubstr(kind));
    const ProgramRun run =
        done({"fit", in(folder, "study/study.yaml"), "-o", in(folder, "fit"), "--json"});
    const auto fit = nlohmann::json::parse(run.out);
    ASSERT_FALSE(fit["experiments"].empty()) << kind;
    for (const auto& e : fit["experiments"]) EXPECT_GT(e["r_squared"].get<double>(), 0.99) << kind;
    EXPECT_THAT(content_of(folder.path() / "fit/report.html"), HasSubstr("I1-bar.linear.c"));
    done({"evaluate", in(folder, "study/study.yaml"), "-m", in(folder, "fit/material.json"), "-o",
          in(folder, "evaluation")});
    EXPECT_TRUE(fs::exists(folder.path() / "evaluation/report.html")) << kind;
  }
}

TEST(SolidProgram, StartsAStudyFromATableOfStretchesAndStresses) {
  const TemporaryFolder folder;
  const std::string rows = "1,0,planar\n1.2,0.1,planar\n1.6,0.25,planar\n2,0.4,planar\n";
  folder.write("rubber.csv", "stretch,nominal_stress_MPa,mode\n" + rows);
  done({"init", "--from", in(folder, "rubber.csv"), "-o", in(folder, "study")});
  const std::string study = content_of(folder.path() / "study/study.yaml");
  EXPECT_THAT(study, HasSubstr("type: homogeneous"));
  EXPECT_THAT(study, ::testing::Not(HasSubstr("mode:")));  // the table tells the mode
  done({"fit", in(folder, "study/study.yaml"), "-o", in(folder, "fit")});
  folder.write("pull.csv", "stretch,nominal_stress_MPa\n1,0\n1.2,0.1\n1.6,0.25\n2,0.4\n");
  done({"init", "--from", in(folder, "pull.csv"), "-o", in(folder, "other")});
  EXPECT_THAT(content_of(folder.path() / "other/study.yaml"), HasSubstr("mode: ???"));
}

TEST(SolidProgram, FitsOfSolidsKeepNoProgressToResume) {
  const TemporaryFolder folder;
  done({"init", "homogeneous", "-o", in(folder, "study")});
  folder.write("fit/progress.bin", "");
  const ProgramRun run =
      run_program({"fit", in(folder, "study/study.yaml"), "-o", in(folder, "fit"), "--resume"});
  EXPECT_EQ(run.status, 2);
}

TEST(SolidProgram, TellsLimitsAndWhereEllipticityIsLost) {
  const TemporaryFolder folder;
  folder.write("foam.json",
               R"({"pliant": "material/1", "name": "foam", "kind": "solid", "density": 100,
                   "components": {"trace": {"stiffness": {"curve": "constant", "value": 2e4}},
                                  "trace-of-square": {"addends": [{"law": "linear", "c": 1e4}]}},
                   "limits": [{"of": ["trace"], "energy": 400}]})");
  const ProgramRun run = done({"info", in(folder, "foam.json"), "--json"});
  const auto info = nlohmann::json::parse(run.out);
  EXPECT_NEAR(info["limits"][0]["strains"][1].get<double>(), 0.2, 1e-9);
  int lost = 0;
  for (const auto& way : info["strong_ellipticity"]) lost += way["lost_at"].is_number();
  EXPECT_GT(lost, 0);
  EXPECT_THAT(done({"info", in(folder, "foam.json")}).out, HasSubstr("stays below 400 J/m^3"));
}

TEST(SolidProgram, MeasuresASolidVirtually) {
  const TemporaryFolder folder;
  folder.write("rubber.json",
               R"({"pliant": "material/1", "name": "rubber", "kind": "solid", "density": 950,
                   "components": {"I1-bar": {"addends": [{"law": "linear", "c": 3e5}]}}})");
  folder.write("lab.yaml",
               "pliant: lab/1\nmaterial: rubber.json\nspecimens: 2\nexperiments:\n"
               "  - {name: pull, type: homogeneous, mode: uniaxial, peaks: [3], noise: 1 kPa}\n");
  done({"lab", in(folder, "lab.yaml"), "-o", in(folder, "lab")});
  const ProgramRun run =
      done({"fit", in(folder, "lab/study.yaml"), "-o", in(folder, "fit"), "--json"});
  const auto fit = nlohmann::json::parse(run.out);
  EXPECT_GT(fit["experiments"][0]["r_squared"].get<double>(), 0.999);
  EXPECT_EQ(fit["experiments"][0]["specimens"], 2);
}

// [T] Fig. 4.2: a large negative lambda makes the energy fall where the volume changes.
TEST(SolidProgram, TellsOfALargeNegativeLambda) {
  const TemporaryFolder folder;
  folder.write("stvk.json",
               R"({"pliant": "material/1", "name": "stvk", "kind": "solid", "components": {
                   "trace": {"stiffness": {"curve": "constant", "value": -5e6}},
                   "trace-of-square": {"addends": [{"law": "linear", "c": 1e6}]}}})");
  const ProgramRun run = done({"info", in(folder, "stvk.json")});
  EXPECT_THAT(run.out + run.err, HasSubstr("the energy of trace is not convex in its strain"));
  EXPECT_THAT(run.out + run.err, HasSubstr("not stable at rest"));
}

}  // namespace
}  // namespace pliant::test
