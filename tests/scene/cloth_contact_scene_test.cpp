// Cloth on cloth: nothing passes through, which an exact test tells that knows nothing of contact;
// no energy is gained; friction is Coulomb's.

#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/geometry/crossings.h"

#include "io/input_error_of.h"
#include "scene/simulated_scene.h"

namespace pliant {
namespace {

using test::simulated;
using ::testing::HasSubstr;

size_t crossings(const Simulation& simulation) {
  return crossing_triangles(simulation.now().state.configuration.positions,
                            simulation.built().faces)
      .value_or(std::vector<std::array<int, 2>>{})
      .size();
}

/// Steps to the end; after each, no triangles cross.
void expect_no_crossings(Simulation& simulation) {
  while (!simulation.is_finished()) {
    simulation.advance();
    ASSERT_EQ(crossings(simulation), 0u) << simulation.now().state.time;
  }
}

/// A sheet that falls on its lower edge and folds over itself.
std::string falling_upright(const std::string& contact) {
  return "cloth:\n"
         "  - {name: sheet, mesh: {grid: 100 mm x 150 mm, nodes: 11x16}, material: jersey.json,\n"
         "     place: {rotate: {axis: [1, 0, 0], angle: 80 deg}, translate: [0, 0, 0.005]}}\n"
         "obstacles:\n"
         "  - {name: floor, plane: {point: [0, 0, 0], normal: [0, 0, 1]}}\n"
         "contact: " +
         contact +
         "\n"
         "time: {step: 5 ms, duration: 400 ms}\n";
}

TEST(ClothOnCloth, PassesThroughWhereContactIsNotAskedFor) {
  Simulation simulation = simulated(falling_upright("{thickness: 1 mm}"));
  if (!crossing_triangles(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0))) {
    GTEST_SKIP() << "built without CGAL";
  }
  bool passes = false;
  while (!simulation.is_finished()) {
    simulation.advance();
    passes |= crossings(simulation) > 0;
  }
  EXPECT_TRUE(passes);
}

TEST(SlowClothOnCloth, FoldsOverItselfWithoutGainingEnergy) {
  for (const double friction : {0.0, 0.5}) {
    Simulation simulation =
        simulated(falling_upright(fmt::format("{{thickness: 1 mm, friction: {}}}", friction)));
    double total = INFINITY;
    bool touched = false;
    while (!simulation.is_finished()) {
      simulation.advance();
      ASSERT_EQ(crossings(simulation), 0u) << simulation.now().state.time;
      simulation.record_frame();
      const double now = simulation.now().energies.back().total();
      EXPECT_LE(now, total + 1e-9) << simulation.now().state.time;
      total = now;
      const auto& positions = simulation.now().state.configuration.positions;
      touched |= simulation.built().surface_contact->touching(positions).front().count > 0;
    }
    EXPECT_TRUE(touched);
  }
}

TEST(ClothOnCloth, OfSeveralPiecesKeepsThemApart) {
  Simulation simulation = simulated(
      "cloth:\n"
      "  - {name: net, mesh: {grid: 100 mm x 100 mm, nodes: 11x11}, material: jersey.json}\n"
      "  - {name: patch, mesh: {grid: 60 mm x 60 mm, nodes: 8x8}, material: jersey.json,\n"
      "     place: {rotate: {axis: [0, 0, 1], angle: 30 deg}, translate: [0.03, 0, 0.01]}}\n"
      "pins:\n"
      "  - {cloth: net, vertices: [0, 10, 110, 120]}\n"
      "contact: {thickness: 1 mm, friction: 0.4}\n"
      "time: {step: 5 ms, duration: 400 ms}\n");
  expect_no_crossings(simulation);
  // It lies in the net.
  const auto& positions = simulation.now().state.configuration.positions;
  const auto patch = positions.rightCols(64);
  EXPECT_GT(patch.row(2).minCoeff(), positions.leftCols(121).row(2).minCoeff());
  EXPECT_LT(patch.row(2).maxCoeff(), 0.01);
}

// What is led moves within the search: it does not jump through what it meets.
TEST(SlowClothOnCloth, IsTwistedByClipsWithoutPassingThroughItself) {
  Simulation simulation = simulated(
      "cloth:\n"
      "  - {name: sheet, mesh: {grid: 100 mm x 60 mm, nodes: 16x10}, material: jersey.json}\n"
      "gravity: [0, 0, 0]\n"
      "damping: {fraction: 0.05}\n"
      "clips:\n"
      "  - {name: left, cloth: sheet, mass: 10 g,\n"
      "     within: {box: {low: [-0.001, -1, -1], high: [0.001, 1, 1]}}}\n"
      "  - {name: right, cloth: sheet, mass: 10 g,\n"
      "     within: {box: {low: [0.099, -1, -1], high: [0.101, 1, 1]}},\n"
      "     motion: {pivot: [0.1, 0.03, 0], keyframes: [{time: 0 s}, {time: 400 ms,\n"
      "       translate: [-0.05, 0, 0], rotate: {axis: [1, 0, 0], angle: 540 deg}}]}}\n"
      "contact: {thickness: 1 mm, friction: 0.3}\n"
      "time: {step: 5 ms, duration: 400 ms}\n");
  expect_no_crossings(simulation);
}

/// A small sheet upon one that is held, under a gravity that slopes: how fast it ends (m/s).
double speed_on_slope(double degrees, double friction, const char* step) {
  const double angle = degrees * std::numbers::pi / 180;
  Simulation simulation = simulated(fmt::format(
      "cloth:\n"
      "  - {{name: table, mesh: {{grid: 200 mm x 100 mm, nodes: 9x5}}, material: jersey.json}}\n"
      "  - {{name: sheet, mesh: {{grid: 40 mm x 40 mm, nodes: 4x4}}, material: jersey.json,\n"
      "     place: {{translate: [0.02, 0.03, 0.00095]}}}}\n"
      "pins: [{{cloth: table, within: {{box: {{low: [-1, -1, -1], high: [1, 1, 1]}}}}}}]\n"
      "contact: {{thickness: 1 mm, friction: {}}}\n"
      "gravity: [{}, 0, {}]\n"
      "time: {{step: {}, duration: 300 ms}}\n",
      friction, 9.80665 * std::sin(angle), -9.80665 * std::cos(angle), step));
  while (!simulation.is_finished()) simulation.advance();
  return simulation.now().state.velocities.rightCols(16).row(0).mean();
}

TEST(ClothOnCloth, SlidesWhereTheSlopeIsSteeperThanItsFriction) {
  for (const double friction : {0.5, 0.0}) {
    const double limit = std::atan(friction) * 180 / std::numbers::pi;
    const double steeper = (limit + 15) * std::numbers::pi / 180;
    const double slides = 9.80665 * (std::sin(steeper) - friction * std::cos(steeper)) * 0.3;
    for (const char* step : {"5 ms", "1 ms"}) {
      // Vertices and edges that pass over each other lift it, and change what presses.
      const double speed = speed_on_slope(limit + 15, friction, step) / slides;
      EXPECT_NEAR(speed, 1, 0.05) << friction << " in steps of " << step;
    }
    if (friction > 0) {
      EXPECT_LT(speed_on_slope(limit - 1, friction, "5 ms"), 1e-3) << "sticking";
    }
  }
}

constexpr const char* kSheet =
    "cloth:\n"
    "  - {name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 11x11}, material: jersey.json}\n";

TEST(ClothOnCloth, IsRefusedWhereItBeginsPassingThroughItself) {
  const InputError error = test::input_error_of([] {
    simulated(
        "cloth:\n"
        "  - {name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 2x2}, material: jersey.json}\n"
        "  - {name: other, mesh: {grid: 10 mm x 10 mm, nodes: 2x2}, material: jersey.json,\n"
        "     place: {rotate: {axis: [1, 0, 0], angle: 90 deg}, translate: [0.06, 0.03, -0.003]}}\n"
        "contact: {friction: 0.5}\n"
        "time: {step: 5 ms, duration: 10 ms}\n");
  });
  EXPECT_EQ(error.where().line, 6);
  EXPECT_EQ(error.where().field, "contact");
  // Both faces of the other stand in the first of the sheet, that below its diagonal.
  EXPECT_THAT(error.what(),
              HasSubstr("cloth begins passing through cloth: 2 pairs of faces, the first of them 0 "
                        "and 2, counted from 0 over all cloth"));
}

TEST(ClothOnCloth, IsThinnerThanHalfAnEdge) {
  const InputError error = test::input_error_of([] {
    simulated(std::string(kSheet) +
              "contact: {thickness: 5 mm, friction: 0.5}\n"
              "time: {step: 5 ms, duration: 10 ms}\n");
  });
  EXPECT_EQ(error.where().field, "contact.thickness");
  EXPECT_THAT(error.what(), HasSubstr("less than half the shortest edge, which is 10 mm long"));
}

TEST(ClothOnCloth, NeedsStepsThatSearch) {
  for (const char* time : {"{kind: quasi-static, steps: 2, duration: 1 s}",
                           "{step: 5 ms, duration: 10 ms, solve: linearized}"}) {
    const InputError error = test::input_error_of(
        [&] { simulated(std::string(kSheet) + "contact: {friction: 0.5}\ntime: " + time + "\n"); });
    EXPECT_EQ(error.where().field, "contact.friction") << time;
  }
}

TEST(ClothOnCloth, IsWarnedOfWhereItBeginsTooNear) {
  const Simulation simulation =
      simulated(std::string(kSheet) +
                "  - {name: other, mesh: {grid: 60 mm x 60 mm, nodes: 7x7}, material: jersey.json,"
                "     place: {translate: [0.02, 0.02, 0.0005]}}\n"
                "contact: {friction: 0.5}\n"
                "time: {step: 5 ms, duration: 10 ms}\n");
  EXPECT_THAT(simulation.built().warnings,
              ::testing::Contains(HasSubstr("begin nearer to each other than the thickness")));
}

}  // namespace
}  // namespace pliant
