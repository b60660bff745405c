// A real garment that falls from its shoulders; skipped where PLIANT_TEST_DATA does not hold it.

#include <cstdlib>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/scene_simulation.h"

namespace pliant::test {
namespace {

// Its seams start with folds of up to 130 degrees that spring open within a step, and slivers stand
// beside them.
TEST(RealGarment, ShirtFallsFromItsShouldersInConvergedSteps) {
  const char* data = std::getenv("PLIANT_TEST_DATA");
  const auto mesh =
      std::filesystem::path(data == nullptr ? "" : data) / "garment_meshes/tshirt-iso.obj";
  if (!std::filesystem::exists(mesh)) GTEST_SKIP() << "PLIANT_TEST_DATA does not hold " << mesh;

  const std::string scene = fmt::format(
      "pliant: scene/1\n"
      "cloth: [{{name: shirt, mesh: {{file: {}, unit: m}}, material: cloth.json}}]\n"
      "pins: [{{cloth: shirt, within: {{box: {{low: [-1, -1, 0.82], high: [1, 1, 1]}}}}}}]\n"
      "time: {{step: 5 ms, duration: 100 ms}}\n",
      mesh.string());
  Simulation simulation = simulation_of(scene, linear_cloth(30, 10, 1e-5));
  take_steps(simulation, 20);
  EXPECT_TRUE(simulation.is_finished());
  EXPECT_TRUE(simulation.now().state.configuration.positions.allFinite());
  simulation.record_frame();
  EXPECT_GT(simulation.now().energies.back().kinetic, 0);
  EXPECT_LT(way(simulation).row(2).minCoeff(), -0.01);  // it sags
}

}  // namespace
}  // namespace pliant::test
