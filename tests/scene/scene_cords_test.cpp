// Cords pull at clips as a scene says, where it says, and along with time.

#include <gtest/gtest.h>

#include "pliant/scene/simulation.h"

#include "support/scene_simulation.h"

namespace pliant {
namespace {

using test::ClampedStrip;
using test::simulation_of;
using test::take_steps;

constexpr double kTolerance = 1e-9;  // N, of the equilibria here

/// A strip of one degree of freedom without weight, whose clip is pulled by a cord through four
/// equilibria at 0.25 s from each other.
Simulation pulled_by(const std::string& cord) {
  return simulation_of(
      ClampedStrip::scene(
          "gravity: [0, 0, 0]\n"
          "time: {kind: quasi-static, steps: 4, duration: 1 s, tolerance: 1e-9 N}\n",
          ", cords: [{" + cord + "}]"),
      ClampedStrip::material());
}

TEST(SceneCords, AForceThatGrowsIsBalancedAtEveryStep) {
  for (const char* where : {"at: [0.02, 0.1, 0]", "vertex: 4"}) {
    Simulation strip = pulled_by(std::string(where) +
                                 ", force: {keyframes: [{time: 0 s, value: [0, 0, 0]}, "
                                 "{time: 1 s, value: [0, 0.4, 0]}]}");
    for (int i = 1; i <= 4; ++i) {
      take_steps(strip, 1);
      EXPECT_NEAR(ClampedStrip::elastic_pull(ClampedStrip::length(strip)), 0.1 * i,
                  10 * kTolerance);
    }
  }
}

// The cord of 50 mm and 8 N/m becomes taut as its end leaves.
TEST(SceneCords, AnElasticCordFollowsItsMovingEnd) {
  for (const char* where : {"at: [0.02, 0.1, 0]", "vertex: 4"}) {
    Simulation strip = pulled_by(std::string(where) +
                                 ", length: 50 mm, stiffness: 8 N/m, end: {keyframes: "
                                 "[{time: 0.25 s, value: [0.02, 0.14, 0]}, "
                                 "{time: 1 s, value: [0.02, 0.23, 0]}]}");
    take_steps(strip, 1);
    EXPECT_EQ(ClampedStrip::length(strip), ClampedStrip::kLength);  // slack
    for (const double end : {0.17, 0.2, 0.23}) {
      take_steps(strip, 1);
      const double length = ClampedStrip::length(strip);
      EXPECT_GT(length, ClampedStrip::kLength + 0.005);
      EXPECT_NEAR(ClampedStrip::elastic_pull(length), 8 * (end - length - 0.05), 10 * kTolerance);
    }
  }
}

// A clip turns until the force goes through the middle of what holds it.
TEST(SceneCords, AForceBesideTheMiddleTurnsTheClip) {
  Simulation strip = pulled_by("at: [0.04, 0.1, 0], force: [0, 0.2, 0]");
  take_steps(strip, 1);
  const Eigen::Vector3d left = strip.now().state.configuration.positions.col(3);
  const Eigen::Vector3d right = strip.now().state.configuration.positions.col(5);
  EXPECT_GT(right.y(), left.y() + 1e-3);
  EXPECT_NEAR((right - left).norm(), ClampedStrip::kWidth, 1e-12);
}

}  // namespace
}  // namespace pliant
