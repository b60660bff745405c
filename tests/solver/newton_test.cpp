#include "pliant/solver/newton.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/mechanics/cord.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/solver/static_solver.h"

namespace pliant {
namespace {

/// A rod of three points that turns about its middle, with opposite forces along x at its ends.
struct PulledRod {
  static constexpr double kRadius = 0.1, kForce = 0.3;  // m, N
  System system;

  /// @param angle  from x, in the plane of x and y
  explicit PulledRod(double angle) : system(points(angle), Eigen::Vector3d::Zero()) {
    system.coordinates().add_clip({0, 1, 2}, false);
    system.add(std::make_shared<Cord>(1, 1, 0, Eigen::Vector3d::Zero()));
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, 3);
    forces(0, 0) = -kForce;
    forces(0, 2) = kForce;
    system.add(std::make_shared<PointForces>(forces));
    system.finish();
  }

  static Eigen::Matrix3Xd points(double angle) {
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 3);
    points.col(2) = kRadius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
    points.col(0) = -points.col(2);
    return points;
  }
};

TEST(Newton, TheLargestForceCountsTheMomentOnAClipOverItsRadius) {
  const PulledRod rod(M_PI / 6);
  const State state = rod.system.initial_state();
  const Eigen::Matrix3Xd gradient = Objective(rod.system, {state}).gradient(state.configuration);
  EXPECT_EQ(gradient.rowwise().sum().norm(), 0);
  EXPECT_NEAR(largest_force(rod.system.coordinates(), state.configuration, gradient),
              2 * PulledRod::kForce * std::sin(M_PI / 6), 1e-15);
}

TEST(Newton, TurnsAFreeClipUntilNoMomentIsLeft) {
  for (const double angle : {0.1, 1.5, 3.0}) {
    const PulledRod rod(angle);
    State state = rod.system.initial_state();
    NewtonOptions options;
    options.tolerance = 1e-9;
    const NewtonSummary summary = StaticSolver(rod.system, options).find_equilibrium(state);
    EXPECT_TRUE(summary.converged);
    EXPECT_GT(summary.iterations, 0);
    // Tolerance over force, times radius.
    EXPECT_LT((state.configuration.positions - PulledRod::points(0)).norm(), 1e-8) << angle;
  }
}

}  // namespace
}  // namespace pliant
