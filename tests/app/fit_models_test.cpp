// `pliant fit --models --variants`: several cloth models fitted to the same sessions.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/text_file.h"

#include "app/virtual_weights.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

/// A stretch and an overhanging sheet, on small meshes, and the study of both.
class SessionsFolder : public MeasuredFolder {
 public:
  /// @param mesh  of the sessions, as a lab has it
  explicit SessionsFolder(const std::string& mesh) : MeasuredFolder(lab(mesh)) {
    EXPECT_EQ(made.status, 0) << made.err;
    std::string text = read_text_file(MeasuredFolder::study());
    text.resize(text.find("model:"));
    study = write("study/sheets.yaml", text + "model: {mesh: measured}\n").string();
  }

  std::string study;  // that takes the sessions' own meshes
  std::string out() const { return file("out"); }

 private:
  static std::string lab(const std::string& mesh) {
    return "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
           "/examples/assumed-cloth.json\nexperiments:\n"
           "  - {name: pull, type: session, test: stretch-weft, frames: 3, mesh: " +
           mesh +
           "}\n"
           "  - {name: table, type: session, test: bend-weft, frames: 3, mesh: " +
           mesh + "}\n";
  }
};

TEST(FitModels, WriteAFolderForEachAndATable) {
  const SessionsFolder folder("{nodes: 7x7}");
  const ProgramRun run = run_program({"fit", folder.study, "--models", "stvk,springs", "--variants",
                                      "linear-isotropic", "-o", folder.out(), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const json summary = json::parse(run.out);
  EXPECT_EQ(summary["pliant"], "fits-of-models/1");
  ASSERT_EQ(summary["fits"].size(), 2u);
  for (const json& fit : summary["fits"]) {
    const std::filesystem::path results = std::filesystem::path(folder.out()) / fit["folder"];
    for (const char* file : {"fit.json", "material.json", "report.html", "study.resolved.yaml",
                             "measures/pull.csv", "predictions/table.csv"}) {
      EXPECT_TRUE(std::filesystem::exists(results / file)) << results / file;
    }
    const json own = json::parse(read_text_file(results / "fit.json"));
    EXPECT_EQ(own["experiments"][0]["rms_force_N"], fit["experiments"][0]["rms"]);
    EXPECT_EQ(own["experiments"][1]["rms_position_mm"], fit["experiments"][1]["rms"]);
    EXPECT_GT(own["experiments"][1]["fold_height_error_mm"], 0);
    EXPECT_TRUE(own["experiments"][1]["measure_file"].is_null()) << "a table has no clips";
    EXPECT_EQ(own["parameters"].size(), fit["parameters"]);
    const json& work = own["work"];
    EXPECT_GT(work["equilibria"], 0);
    EXPECT_GT(work["equilibria_by_differences"], work["equilibria"]);
    double seconds = 0;
    for (const json& part : work["seconds"]) seconds += part.get<double>();
    EXPECT_NEAR(seconds, own["seconds"], 1e-6);
  }
  const std::string csv = read_text_file(std::filesystem::path(folder.out()) / "summary.csv");
  EXPECT_THAT(csv, StartsWith("model,variant,pull_N,table_mm,misfit_percent,parameters,converged,"
                              "seconds,failure\nstvk,linear-isotropic,"));
  EXPECT_THAT(run.err, HasSubstr("pull, N"));
  const std::filesystem::path report = std::filesystem::path(folder.out()) / "report.html";
  const std::string html = read_text_file(report);
  EXPECT_THAT(html, HasSubstr("springs.linear-isotropic/report.html"));
  std::filesystem::remove(report);
  ASSERT_EQ(run_program({"report", folder.out()}).status, 0);
  EXPECT_EQ(read_text_file(report), html);
  // The resolved study of a fit is the study of that fit.
  const ProgramRun info =
      run_program({"info", folder.out() + "/springs.linear-isotropic/study.resolved.yaml"});
  EXPECT_EQ(info.status, 0) << info.err;
}

TEST(FitModels, GoOnWhereOneFails) {
  const SessionsFolder folder("{edge: 15 mm}");
  const ProgramRun run = run_program({"fit", folder.study, "--models", "stvk,springs", "--variants",
                                      "linear-isotropic", "-o", folder.out(), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const json fits = json::parse(run.out)["fits"];
  EXPECT_TRUE(fits[0]["failure"].is_null());
  EXPECT_THAT(fits[1]["failure"].get<std::string>(), HasSubstr("no grid of rectangles"));
  EXPECT_TRUE(fits[1]["folder"].is_null());
  EXPECT_FALSE(
      std::filesystem::exists(std::filesystem::path(folder.out()) / "springs.linear-isotropic"));
}

TEST(FitModels, LeaveNothingWhereAllFail) {
  const SessionsFolder folder("{edge: 15 mm}");
  const ProgramRun run =
      run_program({"fit", "-o", folder.out(), "--models", "springs", folder.study});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("sheets.yaml:"));
  EXPECT_THAT(run.last_line(), HasSubstr("springs cannot simulate \"pull\""));
  EXPECT_FALSE(std::filesystem::exists(folder.out()));
}

TEST(FitModels, NeedSessionsAndKnownNames) {
  const TemporaryFolder folder;
  folder.write("warp.csv", "weight_N,length_mm\n0,100\n1,105\n2,110\n");
  const std::string study =
      folder
          .write("study.yaml",
                 "pliant: study/1\nname: s\nexperiments:\n  - {name: warp, type: hanging-weights, "
                 "direction: warp, data: warp.csv, length: 100 mm, width: 50 mm}\n")
          .string();
  const std::string out = (folder.path() / "out").string();
  const ProgramRun run = run_program({"fit", study, "--models", "all", "-o", out});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("no session to be fitted"));
  EXPECT_EQ(run_program({"fit", study, "--models", "rubber", "-o", out}).status, 2);
}

}  // namespace
}  // namespace pliant::test
