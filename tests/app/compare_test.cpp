// How far shapes of simulated cloth are apart, as a user asks for it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/csv.h"

#include "app/scene_folder.h"
#include "support/simulation_folder.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// A square of 1 m that falls to the floor, of two triangles, with its rest plane.
class Compare : public ::testing::Test {
 protected:
  Compare() {
    folder.write("sim/cloth.obj",
                 "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                 "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
    const std::string summary = content_of(folder.path() / "sim/simulation.json");
    folder.write("sim/simulation.json",
                 edited_text(summary, {{"\"steps\": 9", "\"steps\": 9, \"mesh\": \"cloth.obj\""}}));
  }

  ProgramRun compare(const std::vector<std::string>& arguments = {}) const {
    std::vector<std::string> all{"compare", folder.file("sim")};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program(all);
  }
  json compared(std::vector<std::string> arguments = {}) const {
    arguments.push_back("--json");
    const ProgramRun run = compare(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    return json::parse(run.out)["frames"];
  }

  const SimulationFolder folder{5};
};

// Frame i has its upper side, half of the area, lower by i / 5 m.
TEST_F(Compare, TellsHowFarEachFrameIsFromTheFirst) {
  const json frames = compared();
  ASSERT_EQ(frames.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(frames[i]["with_frame"], 0);
    EXPECT_NEAR(frames[i]["distance"], 0.2 * i / std::sqrt(2), 1e-12);
    EXPECT_NEAR(frames[i]["largest_distance"], 0.2 * i, 1e-12);
    EXPECT_NEAR(frames[i]["curvature"], 0, 1e-12);
  }
}

TEST_F(Compare, ComparesWithTheFrameAskedFor) {
  const json frames = compared({"--to", "4"});
  EXPECT_NEAR(frames[1]["largest_distance"], 0.6, 1e-12);
  EXPECT_EQ(frames[4]["largest_distance"], 0);
}

TEST_F(Compare, ComparesFramesOfTheSameTimeInTwoSimulations) {
  for (const json& frame : compared({folder.file("sim")})) {
    EXPECT_EQ(frame["with_frame"], frame["frame"]);
    EXPECT_EQ(frame["distance"], 0);
  }
}

TEST_F(Compare, PrintsATableAndWritesIt) {
  const ProgramRun run = compare({"-o", folder.file("table.csv")});
  EXPECT_THAT(run.out, HasSubstr("distance, mm"));
  EXPECT_EQ(std::ranges::count(run.out, '\n'), 6);
  EXPECT_EQ(read_csv(folder.file("table.csv")).numbers("largest_distance_m").size(), 5u);
}

TEST_F(Compare, RefusesFramesThatAreNotThere) {
  const ProgramRun run = compare({"--to", "7"});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("has no frame 7; expected 0 to 4"));
}

TEST_F(Compare, RefusesResultsOfAnotherMesh) {
  SceneFolder other;
  other.write("scene.yaml", small_scene("{step: 10 ms, duration: 40 ms}", "{every: 40 ms}"));
  ASSERT_EQ(other.simulate({"--no-report"}).status, 0);
  const ProgramRun run = compare({other.results().string()});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("is of another mesh"));
}

TEST(SimulateWithoutFriction, IsTheSceneThatLeavesItOut) {
  SceneFolder folder;
  const std::string time = "{step: 10 ms, duration: 60 ms}", output = "{every: 20 ms}";
  folder.write("scene.yaml", small_scene(time, output));
  ASSERT_EQ(folder.simulate({"--no-report", "--no-friction"}, "left-out").status, 0);
  EXPECT_EQ(
      json::parse(content_of(folder.results("left-out") / "simulation.json"))["method"]["friction"],
      "none");
  // A checkpoint knows which of the two it is of.
  const ProgramRun resumed = folder.simulate({"--resume"}, "left-out");
  EXPECT_EQ(resumed.status, 2);
  EXPECT_THAT(resumed.last_line(), HasSubstr("--no-friction"));
  folder.write("scene.yaml", small_scene("{step: 10 ms, duration: 60 ms, friction: none}", output));
  ASSERT_EQ(folder.simulate({"--no-report"}, "none").status, 0);
  expect_same_files(folder.computed_files("none"), folder.computed_files("left-out"));
}

}  // namespace
}  // namespace pliant::test
