#include "pliant/solver/time_stepper.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/base/random.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/math/simd.h"

#include "support/cloth_sheet.h"

namespace pliant {
namespace {

using test::ClothSheet;

const Eigen::Vector3d kGravity(0, 0, -9.81);

TimeStepOptions converged_steps(double step, double tolerance) {
  TimeStepOptions options;
  options.step = step;
  options.solve = StepSolve::converged;
  options.tolerance = tolerance;
  return options;
}

State advanced(const System& system, const TimeStepOptions& options, State state, int steps) {
  TimeStepper stepper(system, options);
  for (int i = 0; i < steps; ++i) EXPECT_TRUE(stepper.advance(state).converged) << i;
  return state;
}

/// A sheet without pins, in free fall.
struct FreeSheet : ClothSheet {
  explicit FreeSheet(bool gravity) : ClothSheet(regular_grid(0.1, 0.1, 5, 5), test::cotton()) {
    if (gravity) add_gravity();
    system.finish();
  }
};

/// Positions after `steps` steps of free fall from rest, by the formulas of the two schemes.
double fallen(Integrator integrator, double step, int steps) {
  double now = 0, before = 0, speed = 0, speed_before = 0;
  for (int i = 0; i < steps; ++i) {
    const bool two = integrator == Integrator::bdf2 && i > 0;
    const double time = two ? 2 * step / 3 : step;
    const double from = two ? (4 * now - before) / 3 : now;
    const double speed_from = two ? (4 * speed - speed_before) / 3 : speed;
    before = now;
    speed_before = speed;
    speed = speed_from + time * kGravity.z();
    now = from + time * speed;
  }
  return now;
}

TEST(TimeStepper, FreeFallFollowsTheSchemeExactly) {
  constexpr double kStep = 0.01;
  constexpr int kSteps = 20;
  const FreeSheet sheet(true);
  for (const Integrator integrator : {Integrator::backward_euler, Integrator::bdf2}) {
    for (const StepSolve solve : {StepSolve::linearized, StepSolve::converged}) {
      TimeStepOptions options = converged_steps(kStep, 1e-10);
      options.integrator = integrator;
      options.solve = solve;
      options.linear_tolerance = 1e-12;
      const State state = advanced(sheet.system, options, sheet.system.initial_state(), kSteps);
      const double expected = fallen(integrator, kStep, kSteps);
      const Eigen::Matrix3Xd way = state.configuration.positions - sheet.mesh.positions;
      // The tolerance of the forces, over the masses and summed over the steps.
      EXPECT_LT(way.topRows<2>().cwiseAbs().maxCoeff(), 1e-8);
      EXPECT_LT((way.row(2).array() - expected).abs().maxCoeff(), 1e-8);
      EXPECT_NEAR(state.time, kStep * kSteps, 1e-12);
    }
  }
  // Backward Euler sums its speeds: g step^2 n (n + 1) / 2.
  EXPECT_NEAR(fallen(Integrator::backward_euler, kStep, kSteps),
              kGravity.z() * kStep * kStep * kSteps * (kSteps + 1) / 2, 1e-12);
  // BDF2 is exact for a uniform acceleration but for its first step, of backward Euler.
  EXPECT_NEAR(fallen(Integrator::bdf2, kStep, kSteps),
              kGravity.z() * (std::pow(kStep * kSteps, 2) / 2 + 0.75 * kStep * kStep), 1e-9);
}

State thrown(const System& system, std::uint64_t seed) {
  State state = system.initial_state();
  RandomStream random(seed);
  for (int i = 0; i < system.points(); ++i) {
    for (int a = 0; a < 3; ++a) state.velocities(a, i) = random.uniform(-1, 1);
  }
  return state;
}

TEST(TimeStepper, KeepsLinearMomentumWithoutForcesFromOutside) {
  const FreeSheet sheet(false);
  const State start = thrown(sheet.system, 3);
  const Eigen::Vector3d momentum = start.velocities * sheet.system.masses();
  for (const Integrator integrator : {Integrator::backward_euler, Integrator::bdf2}) {
    TimeStepOptions options = converged_steps(0.002, 1e-9);
    options.integrator = integrator;
    const State state = advanced(sheet.system, options, start, 50);
    // Steps times time step times points times tolerance.
    EXPECT_LT((state.velocities * sheet.system.masses() - momentum).norm(), 5e-9);
    EXPECT_GT((state.velocities - start.velocities).norm(), 0.5 * start.velocities.norm());
  }
}

TEST(TimeStepper, RepeatsItselfToTheLastBitOnVectorsOfAnyWidth) {
  const FreeSheet sheet(true);
  for (const StepSolve solve : {StepSolve::linearized, StepSolve::iterated, StepSolve::converged}) {
    TimeStepOptions options = converged_steps(0.005, 1e-6);
    options.solve = solve;
    const State once = advanced(sheet.system, options, thrown(sheet.system, 8), 10);
    const auto expect_the_same = [&] {
      const State again = advanced(sheet.system, options, thrown(sheet.system, 8), 10);
      EXPECT_EQ(once.configuration.positions, again.configuration.positions);
      EXPECT_EQ(once.velocities, again.velocities);
      EXPECT_EQ(once.history, again.history);
    };
    expect_the_same();
    const simd::Narrow narrow;
    expect_the_same();
  }
}

TEST(TimeStepper, PointsAndClipsFollowTheirDrives) {
  ClothSheet sheet(regular_grid(0.1, 0.1, 5, 5), test::cotton());
  const std::vector<int> low = sheet.row_at(0), high = sheet.row_at(0.1);
  sheet.prescribe(high);
  const int clip = sheet.system.coordinates().add_clip(low, true);
  const auto high_at = [&](double time, int i) -> Eigen::Vector3d {
    return sheet.mesh.positions.col(i) + Eigen::Vector3d(0.02 * std::sin(10 * time), 0, time);
  };
  const auto pose_at = [](double time) {
    return Pose{Eigen::Quaterniond(Eigen::AngleAxisd(3 * time, Eigen::Vector3d::UnitX())),
                Eigen::Vector3d(0.05, -0.1 * time, time)};
  };
  sheet.add_gravity();
  sheet.system.finish();

  constexpr double kStep = 0.005;
  TimeStepOptions options = converged_steps(kStep, 1e-6);
  options.schedule = [&](double time) {
    Controls controls;
    for (const int i : high) controls.places.push_back({i, high_at(time, i)});
    controls.poses.push_back({clip, pose_at(time)});
    return controls;
  };
  TimeStepper stepper(sheet.system, options);
  State state = sheet.system.initial_state();
  for (int step = 0; step < 20; ++step) {
    const Eigen::Matrix3Xd before = state.configuration.positions;
    ASSERT_TRUE(stepper.advance(state).converged);
    const Eigen::Matrix3Xd& x = state.configuration.positions;
    for (const int i : high) EXPECT_EQ(x.col(i), high_at(state.time, i));
    for (const int i : low) {
      const Eigen::Vector3d local = sheet.mesh.positions.col(i) - Eigen::Vector3d(0.05, 0, 0);
      EXPECT_LT((x.col(i) - pose_at(state.time).apply(local)).norm(), 1e-15);
    }
    // Moved points have the velocity of their motion.
    EXPECT_LT((state.velocities - (x - before) / kStep).norm(), 1e-9);
  }
}

/// A row of points slides along x and y, at a height that is driven.
TEST(TimeStepper, AnAxisFollowsItsDriveWhileTheOthersAreFree) {
  ClothSheet sheet(regular_grid(0.1, 0.1, 5, 5), test::cotton());
  const std::vector<int> row = sheet.row_at(0.1);
  for (const int i : row) sheet.system.coordinates().prescribe_axis(i, 2);
  const auto height_at = [](double time) { return 2 * time; };
  sheet.add_gravity(-Eigen::Vector3d::UnitX());
  sheet.system.finish();
  for (const StepSolve solve : {StepSolve::linearized, StepSolve::converged}) {
    TimeStepOptions options = converged_steps(0.005, 1e-6);
    options.solve = solve;
    options.schedule = [&](double time) {
      Controls controls;
      for (const int i : row) {
        controls.places.push_back({i, {0, 0, height_at(time)}, {false, false, true}});
      }
      return controls;
    };
    const State state = advanced(sheet.system, options, sheet.system.initial_state(), 20);
    for (const int i : row) {
      EXPECT_EQ(state.configuration.positions(2, i), height_at(state.time));
      EXPECT_LT(state.configuration.positions(0, i), sheet.mesh.positions(0, i) - 0.01);
    }
  }
}

TEST(TimeStepper, AFreeClipSwingsAsARigidBody) {
  ClothSheet sheet(regular_grid(0.1, 0.1, 5, 5), test::cotton());
  const std::vector<int> low = sheet.row_at(0);
  sheet.prescribe(sheet.row_at(0.1));
  sheet.system.coordinates().add_clip(low, false);
  sheet.add_gravity();
  sheet.system.finish();
  TimeStepOptions options = converged_steps(0.005, 1e-7);
  options.integrator = Integrator::bdf2;
  const State state = advanced(sheet.system, options, sheet.system.initial_state(), 30);
  const Eigen::Matrix3Xd& x = state.configuration.positions;
  EXPECT_LT(x(2, low[0]), -0.03);
  for (const int i : low) {
    const double distance = (sheet.mesh.positions.col(i) - sheet.mesh.positions.col(low[0])).norm();
    EXPECT_NEAR((x.col(i) - x.col(low[0])).norm(), distance, 1e-14);
  }
}

TEST(TimeStepper, AResultThatIsNotFiniteIsRefusedAndTheStateKept) {
  const FreeSheet sheet(true);
  State state = sheet.system.initial_state();
  state.velocities(0, 3) = NAN;
  const State before = state;
  TimeStepOptions options;
  options.solve = StepSolve::linearized;
  TimeStepper stepper(sheet.system, options);
  EXPECT_THROW(stepper.advance(state), SolverError);
  EXPECT_EQ(state.time, before.time);
  EXPECT_EQ(state.configuration.positions, before.configuration.positions);
}

}  // namespace
}  // namespace pliant
