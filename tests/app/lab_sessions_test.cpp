// `pliant lab` makes full-field sessions.

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/run_program.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kLab =
    "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
    "/examples/assumed-cloth.json\nexperiments:\n"
    "  - {name: sheet, type: session, test: stretch-weft, frames: 3, mesh: {nodes: 9x9}}\n"
    "  - {name: table, type: session, test: bend-warp, frames: 2, mesh: {nodes: 9x9}}\n";

TEST(LabSessions, AreWrittenAsDirectoriesThatInfoAccepts) {
  const TemporaryFolder folder;
  const std::string lab = folder.write("lab.yaml", kLab).string();
  const std::string study = (folder.path() / "study").string();
  const ProgramRun made = run_program({"lab", lab, "-o", study, "--threads", "2"});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("2 virtual measurements"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "study" / "truth.json"));
  for (const char* session : {"sheet", "table"}) {
    const ProgramRun info = run_program({"info", (folder.path() / "study" / session).string()});
    EXPECT_EQ(info.status, 0) << info.err;
    EXPECT_THAT(info.out, HasSubstr("session/1"));
  }
  const ProgramRun info = run_program({"info", lab});
  EXPECT_THAT(info.out, HasSubstr("session, stretch-weft"));
  EXPECT_EQ(run_program({"lab", lab, "-o", study}).status, 0) << "its own results are replaced";
}

// How far a material is from a session of 13 x 13 nodes over an edge that it is evaluated on (mm).
double off_by(const TemporaryFolder& folder, const json& material) {
  const std::string study = folder
                                .write("study.yaml",
                                       "pliant: study/1\nname: s\nmodel: {mesh: measured}\n"
                                       "experiments: [{name: t, type: session, data: made/t}]\n")
                                .string();
  const ProgramRun run = run_program({"evaluate", study, "-m",
                                      folder.write("evaluated.json", material.dump()).string(),
                                      "-o", (folder.path() / "results").string(), "--json"});
  EXPECT_EQ(run.status, 0) << run.err;
  return json::parse(run.out)["experiments"][0]["rms_position_mm"].get<double>();
}

TEST(SlowLabSessions, OverAnEdgeAreMetWithTheFrictionOfBendingAlone) {
  const TemporaryFolder folder;
  const std::string lab =
      folder
          .write("lab.yaml", "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
                             "/examples/assumed-cloth.json\nexperiments:\n"
                             "  - {name: t, type: session, test: bend-warp, frames: 4,"
                             " mesh: {nodes: 13x13}}\n")
          .string();
  ASSERT_EQ(run_program({"lab", lab, "-o", (folder.path() / "made").string()}).status, 0);
  json material = json::parse(std::ifstream(PLIANT_SOURCE_DIR "/examples/assumed-cloth.json"));
  EXPECT_LT(off_by(folder, material), 1e-6);
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material["components"][name].erase("friction");
  }
  EXPECT_GT(off_by(folder, material), 0.1);
  const ProgramRun told = run_program({"evaluate", (folder.path() / "study.yaml").string(), "-m",
                                       (folder.path() / "evaluated.json").string(), "-o",
                                       (folder.path() / "results").string()});
  EXPECT_THAT(told.err, HasSubstr("rows, overhang to 60 mm: error"));
  EXPECT_THAT(told.err, HasSubstr("% of length; height of folds: "));
}

TEST(LabSessions, LeaveNothingWhenTheyAreInterrupted) {
  const TemporaryFolder folder;
  const std::string lab =
      folder
          .write("lab.yaml", "pliant: lab/1\nmaterial: " PLIANT_SOURCE_DIR
                             "/examples/assumed-cloth.json\nexperiments:\n"
                             "  - {name: s, type: session, test: complex-shear, frames: 1000}\n")
          .string();
  const ProgramRun run =
      run_program({"lab", lab, "-o", (folder.path() / "study").string()}, {.interrupt_after = 1});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.last_line(), HasSubstr("interrupted"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "study"));
}

}  // namespace
}  // namespace pliant::test
