#include "pliant/mechanics/air_drag.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/solver/time_stepper.h"

#include "support/cloth_systems.h"

namespace pliant {
namespace {

constexpr double kGravity = 9.81;

// A horizontal sheet in air, free to fall.
struct FallingSheet {
  test::ClothSystem cloth =
      test::cloth_system(regular_grid(0.2, 0.2, 5, 5), test::frictional_cotton());
  System& system = *cloth.system;
  State state;

  FallingSheet() {
    const Eigen::Vector3d gravity(0, 0, -kGravity);
    system.add(std::make_shared<PointForces>(gravity * system.masses().transpose()));
    system.finish();
    state = system.initial_state();
  }

  TimeStepper stepper(const Air& air) const {
    TimeStepOptions options;
    options.step = 0.01;
    options.air = air;
    return TimeStepper(system, options, cloth.mesh.triangles);
  }
};

TEST(AirDrag, LetsASheetFallAtItsTerminalVelocity) {
  FallingSheet sheet;
  const Air air{1.2, 1.2, Eigen::Vector3d::Zero()};
  TimeStepper stepper = sheet.stepper(air);
  for (int i = 0; i < 200; ++i) stepper.advance(sheet.state);
  const double terminal =
      std::sqrt(2 * test::frictional_cotton().density * kGravity / (air.drag * air.density));
  // The sheet bends a little: its rim is lighter than its faces' share of the air.
  const double mean =
      sheet.state.velocities.row(2).dot(sheet.system.masses()) / sheet.system.masses().sum();
  EXPECT_NEAR(-mean, terminal, 0.01 * terminal);
}

TEST(AirDrag, TakesTheEnergyThatItSaysItTakes) {
  FallingSheet sheet;
  TimeStepper stepper = sheet.stepper({1.2, 1.2, Eigen::Vector3d::Zero()});
  const auto energy = [&] {
    Derivatives derivatives;
    sheet.system.evaluate(sheet.state.configuration, {sheet.state}, Curvature::exact, derivatives);
    return derivatives.energy.stored +
           sheet.state.velocities.colwise().squaredNorm().dot(sheet.system.masses()) / 2;
  };
  const double start = energy();
  double work = 0;
  for (int i = 0; i < 100; ++i) {
    const StepSummary step = stepper.advance(sheet.state);
    EXPECT_GT(step.work + step.drag, 0);
    work += step.work + step.drag;
  }
  const double lost = start - energy();
  // Backward Euler itself loses energy, of first order in the step: here a few per cent.
  EXPECT_GE(lost, work);
  EXPECT_LT(lost, 1.1 * work);
}

TEST(AirDrag, CarriesASheetWithTheWindAcrossIt) {
  FallingSheet sheet;
  TimeStepper stepper = sheet.stepper({1.2, 1.2, Eigen::Vector3d(3, 0, 20)});
  stepper.advance(sheet.state);
  const Eigen::Vector3d mean = sheet.state.velocities.rowwise().mean();
  EXPECT_GT(mean.z(), 0);          // upwards, against gravity
  EXPECT_NEAR(mean.x(), 0, 1e-4);  // the air slips along a face
}

}  // namespace
}  // namespace pliant
