// Steps of simulations that are halved where they fail.

#include "pliant/scene/simulation.h"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/material/material_file.h"
#include "pliant/scene/scene.h"
#include "pliant/scene/simulation_result.h"

#include "scene/scene_text.h"
#include "scene/simulated_scene.h"

namespace pliant {
namespace {

using test::read_scene_text;
using test::simulated;

/// A sheet with vertices at 25 mm from each other, whose upper corners are held; one is moved.
/// @param time       of the scene
/// @param keyframes  of the moved corner
Simulation sheet(const std::string& time, const std::string& keyframes) {
  const Scene scene = read_scene_text(
      "pliant: scene/1\ntime: " + time +
      "\ncloth:\n"
      "  - {name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 5x5}, material: jersey.json}\n"
      "pins:\n"
      "  - {cloth: sheet, corners: [top-left]}\n"
      "  - {cloth: sheet, corners: [top-right], motion: {keyframes: [" +
      keyframes + "]}}\n");
  return Simulation(scene, read_material(PLIANT_SOURCE_DIR "/examples/assumed-cloth.json"));
}

/// Within 10 ms the corner comes to where its neighbour was: hinges at triangles without area have
/// no angle, so that the search for the step has nowhere to begin.
constexpr const char* kOntoItsNeighbour = "{time: 0 s}, {time: 10 ms, translate: [-0.025, 0, 0]}";

TEST(AdaptiveSteps, AreOffUnlessAskedFor) {
  for (const char* time :
       {"{step: 10 ms, duration: 20 ms}", "{step: 10 ms, duration: 20 ms, adaptive: false}"}) {
    Simulation simulation = sheet(time, kOntoItsNeighbour);
    EXPECT_THROW(simulation.advance(), SolverError);
    EXPECT_EQ(simulation.now().steps, 0);
    EXPECT_EQ(simulation.now().state.time, 0);
    EXPECT_TRUE(simulation.now().records.substeps.empty());
  }
}

TEST(AdaptiveSteps, AreTheStepsOfHalfTheLengthWhereOneFails) {
  for (const char* integrator : {"backward-euler", "bdf2"}) {
    const std::string method = std::string(", integrator: ") + integrator;
    Simulation halved =
        sheet("{step: 10 ms, duration: 30 ms, adaptive: true" + method + "}", kOntoItsNeighbour);
    halved.advance();
    EXPECT_EQ(halved.now().steps, 1);
    EXPECT_EQ(halved.now().state.time, 0.01);
    Simulation shorter = sheet("{step: 5 ms, duration: 30 ms" + method + "}", kOntoItsNeighbour);
    for (int i = 0; i < 2; ++i) shorter.advance();
    EXPECT_EQ(halved.now().state.configuration.positions,
              shorter.now().state.configuration.positions);
    EXPECT_EQ(halved.now().state.velocities, shorter.now().state.velocities);
    EXPECT_EQ(halved.now().state.history, shorter.now().state.history);
    EXPECT_EQ(halved.now().work, shorter.now().work);
  }
}

TEST(AdaptiveSteps, TellHowOftenTheyWereHalvedAndGoOnWithWholeOnes) {
  Simulation simulation =
      sheet("{step: 10 ms, duration: 30 ms, adaptive: true}", kOntoItsNeighbour);
  while (!simulation.is_finished()) simulation.advance();
  EXPECT_EQ(simulation.now().records.substeps, (std::vector{2, 1, 1}));
  const auto json = nlohmann::json::parse(simulation_text(simulation_result(simulation, {})));
  EXPECT_EQ(json["method"]["adaptive"], true);
  EXPECT_EQ(json["substeps"]["max"], 2);
  EXPECT_EQ(json["substeps"]["median"], 1);
}

// The first half of the step works, the second does not however short: nobody can go so far.
TEST(AdaptiveSteps, ThatFailHoweverShortKeepTheStateBeforeTheWholeStep) {
  Simulation simulation = sheet("{step: 10 ms, duration: 20 ms, adaptive: true}",
                                "{time: 5 ms}, {time: 10 ms, translate: [1e200, 0, 0]}");
  const State before = simulation.now().state;
  EXPECT_THROW(simulation.advance(), SolverError);
  EXPECT_EQ(simulation.now().steps, 0);
  EXPECT_EQ(simulation.now().state.time, before.time);
  EXPECT_EQ(simulation.now().state.configuration.positions, before.configuration.positions);
  EXPECT_EQ(simulation.now().state.history, before.history);
}

TEST(IteratedSteps, LeaveASheetAtRestWhereItIs) {
  Simulation sheet = simulated(
      "cloth: [{name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 5x5}, material: jersey.json,\n"
      "         place: {rotate: {axis: [1, 2, 3], angle: 40 deg}}}]\n"
      "gravity: [0, 0, 0]\ntime: {step: 5 ms, duration: 50 ms}\n");
  const Eigen::Matrix3Xd before = sheet.now().state.configuration.positions;
  while (!sheet.is_finished()) sheet.advance();
  EXPECT_LT((sheet.now().state.configuration.positions - before).norm(), 1e-12);
}

}  // namespace
}  // namespace pliant
