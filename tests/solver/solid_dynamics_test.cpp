// Solids in time: what is conserved, and that nothing is ever turned inside out.

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/solver/time_stepper.h"

#include "support/evaluate_system.h"
#include "support/solid_bodies.h"

namespace pliant {
namespace {

using test::Cells;

constexpr double kSize = 0.1, kDensity = 1000;

test::SolidSystem free_block(Cells cells, const SolidLaw& law) {
  test::SolidSystem solid = test::solid_system(
      shaken_inside(test::block_of(cells, Eigen::Vector3d::Constant(kSize), {3, 3, 3}), 0.2, 5),
      law, kDensity);
  solid.system->finish();
  return solid;
}

Eigen::Vector3d momentum(const System& system, const State& state) {
  return state.velocities * system.masses();
}

Eigen::Vector3d angular_momentum(const System& system, const State& state) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < system.points(); ++i) {
    const Eigen::Vector3d x = state.configuration.positions.col(i), v = state.velocities.col(i);
    sum += system.masses()(i) * x.cross(v);
  }
  return sum;
}

double least_volume_ratio(const VolumeMesh& mesh, const Eigen::Matrix3Xd& positions) {
  VolumeMesh moved = mesh;
  moved.positions = positions;
  return element_volumes(moved).cwiseQuotient(element_volumes(mesh)).minCoeff();
}

TEST(SolidMasses, AreThoseOfTheVolume) {
  for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
    const test::SolidSystem solid = free_block(cells, test::stvk_law({1e4, 0.3}));
    const double mass = kDensity * kSize * kSize * kSize;
    EXPECT_NEAR(solid.system->masses().sum(), mass, 1e-14 * mass);
    EXPECT_GT(solid.system->masses().minCoeff(), 0);
    const Eigen::Vector3d centre = solid.mesh.positions * solid.system->masses() / mass;
    EXPECT_TRUE(centre.isApprox(Eigen::Vector3d::Constant(kSize / 2), 1e-13));
  }
}

TEST(SolidDynamics, KeepsTheMomentumOfABodyThatTumblesFreely) {
  for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
    const test::SolidSystem solid = free_block(cells, test::pointwise_rubber_law({1e4, 0.4}));
    State state = solid.system->initial_state();
    const Eigen::Vector3d spin(3, -5, 8);
    for (int i = 0; i < solid.system->points(); ++i) {
      const Eigen::Vector3d x = state.configuration.positions.col(i);
      state.velocities.col(i) = Eigen::Vector3d(0.3, 0, 1) + spin.cross(x);
    }
    const Eigen::Vector3d before = momentum(*solid.system, state);
    const double turning = angular_momentum(*solid.system, state).norm();
    TimeStepOptions options;
    options.step = 1e-3;
    options.integrator = Integrator::bdf2;
    options.solve = StepSolve::converged;
    options.tolerance = 1e-7;  // forces between nodes are near 1 N
    TimeStepper stepper(*solid.system, options);
    for (int step = 0; step < 30; ++step) EXPECT_TRUE(stepper.advance(state).converged);
    // At each step the sum of what is left at the nodes, times the step.
    EXPECT_LT((momentum(*solid.system, state) - before).norm(), 1e-8 * before.norm());
    // BDF2 loses turning at second order of the angle of a step, 0.01.
    EXPECT_NEAR(angular_momentum(*solid.system, state).norm(), turning, 0.01 * turning);
  }
}

TEST(SlowSolidDynamics, KeepsTheVolumeOfRubber) {
  for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
    test::SolidSystem solid =
        test::solid_system(test::block_of(cells, {kSize, kSize, 3 * kSize}, {3, 3, 9}),
                           test::rubber_law({2e4, 0.499}), kDensity);
    solid.hold(nodes_at(solid.mesh, 2, 3 * kSize));
    solid.load(Eigen::Vector3d(5, 0, -9.81) * solid.system->masses().transpose());
    solid.system->finish();
    State state = solid.system->initial_state();
    TimeStepOptions options;
    options.step = 5e-3;
    TimeStepper stepper(*solid.system, options);
    for (int step = 0; step < 40; ++step) EXPECT_TRUE(stepper.advance(state).converged);
    EXPECT_GT((state.configuration.positions - solid.mesh.positions).cwiseAbs().maxCoeff(), 0.02);
    VolumeMesh moved = solid.mesh;
    moved.positions = state.configuration.positions;
    const double volume = element_volumes(solid.mesh).sum();
    // Hydrostatic pressure is near rho g L = 3 kPa over a bulk modulus of 3.3 MPa.
    EXPECT_NEAR(element_volumes(moved).sum(), volume, 2e-3 * volume);
  }
}

// Nodes start at random with velocities that would turn every element inside out within a step.
TEST(SolidDynamics, NeverTurnsAnElementInsideOut) {
  for (const Cells cells : {Cells::tetrahedra, Cells::hexahedra}) {
    const test::SolidSystem solid = free_block(cells, test::pointwise_rubber_law({1e4, 0.3}));
    State state = solid.system->initial_state();
    RandomStream random(7);
    for (double& v : state.velocities.reshaped()) v = 10 * random.normal();
    const Eigen::Matrix3Xd coasted = state.configuration.positions + 5e-3 * state.velocities;
    EXPECT_LT(least_volume_ratio(solid.mesh, coasted), -1);
    TimeStepOptions options;
    options.step = 5e-3;
    TimeStepper stepper(*solid.system, options);
    for (int step = 0; step < 20; ++step) {
      stepper.advance(state);
      EXPECT_GT(least_volume_ratio(solid.mesh, state.configuration.positions), 0);
    }
  }
}

TEST(SolidInversion, HasInfiniteEnergyAndIsNoWayToGo) {
  const VolumeMesh mesh = block_of_tetrahedra({1, 1, 1}, {1, 1, 1});
  const test::SolidSystem solid = test::solid_system(mesh, test::stvk_law({1, 0.3}));
  solid.system->finish();
  const State state = solid.system->initial_state();
  Configuration mirrored = state.configuration;
  mirrored.positions.row(0) *= -1;
  EXPECT_EQ(test::energy_of(*solid.system, mirrored, state).stored, INFINITY);
  EXPECT_TRUE(solid.system->obstructs());
  const WayLimits limits =
      solid.system->way_limits(state.configuration, mirrored, {.from = state}, 0.2);
  EXPECT_TRUE(limits.obstructed);
  // J = 1 - 2 s along the way.
  EXPECT_NEAR(limits.shares.minCoeff(), 0.4, 1e-12);
}

}  // namespace
}  // namespace pliant
