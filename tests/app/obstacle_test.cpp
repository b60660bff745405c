// Cloth on obstacles, from the scene file to the folder of results.

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/obj.h"

#include "app/scene_folder.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The example with fewer vertices and steps, on a ball that rises.
void write_drape(const SceneFolder& folder, const std::string& duration) {
  folder.copy_example("drape-sphere", {{"nodes: 121x121", "nodes: 21x21"},
                                       {"friction: 0.3}",
                                        "friction: 0.3, motion: {keyframes: [{time: 0 s}, "
                                        "{time: 300 ms, translate: [0, 0, 0.05]}]}}"},
                                       {"duration: 800 ms", "duration: " + duration},
                                       {"{thickness: 1 mm,", "{thickness: 4 mm,"}});
}

json summary_in(const std::filesystem::path& results) {
  return json::parse(content_of(results / "simulation.json"));
}

TEST(SimulatedObstacles, StandInTheResults) {
  const SceneFolder folder;
  write_drape(folder, "300 ms");
  const ProgramRun run = folder.simulate({"--no-report"});
  ASSERT_EQ(run.status, 0) << run.err;
  const json result = summary_in(folder.results());
  EXPECT_THAT(result["not_modelled"], IsEmpty());
  EXPECT_GT(result["min_contact_distance"], 0);
  EXPECT_LT(result["min_contact_distance"], 4e-3);
  // 0.3 s are six frames.
  const std::filesystem::path obstacles = folder.results() / result["obstacles"].get<std::string>();
  for (const auto& [x, y, z] : read_obj(obstacles / "000006.obj").positions) {
    EXPECT_NEAR(std::hypot(x, y, z + 0.16), 0.2, 1e-9);
  }
  for (const auto& [x, y, z] : read_obj(folder.results() / "obstacles.obj").positions) {
    EXPECT_NEAR(std::hypot(x, y, z + 0.21), 0.2, 1e-9);
  }
}

TEST(SlowSimulatedObstacles, AreGoneOnWithToTheSameBits) {
  const SceneFolder folder;
  write_drape(folder, "300 ms");
  ASSERT_EQ(folder.simulate({"--no-report"}, "whole").status, 0);
  write_drape(folder, "150 ms");
  ASSERT_EQ(folder.simulate({"--no-report"}).status, 0);
  write_drape(folder, "300 ms");
  const ProgramRun resumed = folder.simulate({"--no-report", "--resume"});
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(content_of(folder.results() / "frames" / "000006.ply"),
            content_of(folder.results("whole") / "frames" / "000006.ply"));
  EXPECT_EQ(content_of(folder.results() / "obstacles" / "000006.obj"),
            content_of(folder.results("whole") / "obstacles" / "000006.obj"));
  EXPECT_EQ(summary_in(folder.results())["min_contact_distance"],
            summary_in(folder.results("whole"))["min_contact_distance"]);
}

// A floor rises to a ceiling with cloth between them.
TEST(SimulatedObstacles, ThatBlockAStepAreNamedAndLeaveACheckpoint) {
  const SceneFolder folder;
  folder.copy_example("drape-sphere",
                      {{"grid: 1 m x 1 m, nodes: 121x121", "grid: 40 mm x 40 mm, nodes: 3x3"},
                       {"place: {translate: [-0.5, -0.5, 0]}", "place: {translate: [0, 0, 0.01]}"},
                       {"sphere: {centre: [0, 0, -0.21], radius: 200 mm}, friction: 0.3",
                        "plane: {point: [0, 0, 0], normal: [0, 0, 1]}, motion: {keyframes: "
                        "[{time: 0 s}, {time: 100 ms, translate: [0, 0, 0.1]}]}}\n"
                        "  - {name: lid, plane: {point: [0, 0, 0.04], normal: [0, 0, -1]}"}});
  const ProgramRun run = folder.simulate({"--no-report"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.last_line(),
              HasSubstr("leaves what it meets no room: nearest to the cloth are "));
  for (const char* blocking : {"\"ball\" ", "\"lid\" "}) {
    EXPECT_THAT(
        run.last_line(),
        ContainsRegex(std::string(blocking) + "\\([0-9.]+ mm from vertex [0-8]; [^ ]*scene.yaml:"));
  }
  EXPECT_THAT(run.last_line(), HasSubstr("the last good state is that of "));
  EXPECT_EQ(summary_in(folder.results())["finished"], false);
  const int steps = summary_in(folder.results())["steps"];
  EXPECT_GT(steps, 0);
  // It goes on from there, to where it was stopped.
  const ProgramRun again = folder.simulate({"--no-report", "--resume"});
  EXPECT_EQ(again.last_line(), run.last_line());
  EXPECT_EQ(summary_in(folder.results())["steps"], steps);
}

// Upright cloth falls through itself where it is not told of itself.
TEST(SlowVerifiedSimulation, StopsWhereTrianglesPassThroughEachOther) {
  const SceneFolder folder;
  for (const bool touches : {false, true}) {
    folder.copy_example("drape-sphere",
                        {{"grid: 1 m x 1 m, nodes: 121x121", "grid: 10 cm x 15 cm, nodes: 11x16"},
                         {"place: {translate: [-0.5, -0.5, 0]}",
                          "place: {rotate: {axis: [1, 0, 0], angle: 80 deg}, translate: [0, 0, "
                          "0.005]}"},
                         {"sphere: {centre: [0, 0, -0.21], radius: 200 mm}",
                          "plane: {point: [0, 0, 0], normal: [0, 0, 1]}"},
                         {", friction: 0.6}", touches ? ", friction: 0.6}" : "}"},
                         {"duration: 800 ms", "duration: 400 ms"}});
    const ProgramRun run = folder.simulate({"--no-report", "--verify"});
    if (run.err.find("built with CGAL") != std::string::npos) GTEST_SKIP() << run.err;
    EXPECT_EQ(run.status, touches ? 0 : 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(touches ? "verified: after no step"
                                           : "triangles pass through each other: "));
    if (touches) {
      EXPECT_THAT(run.err, HasSubstr("after no step is a vertex or a face inside an obstacle"));
    }
  }
}

// A ball that is smaller than a face passes between its vertices, which alone are kept off it.
TEST(VerifiedSimulation, TellsHowFarFacesComeIntoObstacles) {
  const SceneFolder folder;
  folder.copy_example("drape-sphere", {{"nodes: 121x121", "nodes: 11x11"},
                                       {"centre: [0, 0, -0.21], radius: 200 mm",
                                        "centre: [0.05, 0.02, -0.06], radius: 30 mm"},
                                       {"duration: 800 ms", "duration: 150 ms"}});
  const ProgramRun run = folder.simulate({"--no-report", "--verify"});
  if (run.err.find("built with CGAL") != std::string::npos) GTEST_SKIP() << run.err;
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("verified: after no step is a vertex inside an obstacle"));
  EXPECT_THAT(run.err, ContainsRegex("verified: faces come up to [0-9.]+ mm into "
                                     "\"ball\" between their vertices"));
}

}  // namespace
}  // namespace pliant::test
