#include "pliant/mechanics/system.h"

#include <memory>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/math/check_derivatives.h"
#include "pliant/mechanics/cord.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/mechanics/point_targets.h"

#include "support/cloth_systems.h"
#include "support/evaluate_system.h"

namespace pliant {
namespace {

Eigen::Matrix3Xd points_in_a_row(int count) {
  Eigen::Matrix3Xd positions = Eigen::Matrix3Xd::Zero(3, count);
  for (int i = 0; i < count; ++i) positions(0, i) = 0.1 * i;
  return positions;
}

TEST(System, StartsAtRestWhereItsPointsWerePut) {
  System system(points_in_a_row(3), Eigen::VectorXd::Ones(3));
  system.finish();
  const State state = system.initial_state();
  EXPECT_EQ(state.time, 0);
  EXPECT_EQ(state.configuration.positions, points_in_a_row(3));
  EXPECT_EQ(state.velocities, Eigen::Matrix3Xd::Zero(3, 3));
  EXPECT_EQ(state.history.size(), 0);
}

TEST(System, NeedsAMassForEachPoint) {
  EXPECT_THROW(System(points_in_a_row(3), Eigen::VectorXd::Ones(2)), AssertionError);
}

TEST(System, AppliesItsDrivesInTheirOrder) {
  System system(points_in_a_row(2), Eigen::VectorXd::Ones(2));
  system.coordinates().prescribe(1);
  system.add_drive([](double time, Configuration& at) { at.positions(0, 1) = time; });
  system.add_drive([](double, Configuration& at) { at.positions(1, 1) = 2 * at.positions(0, 1); });
  system.finish();
  Configuration at = system.initial_state().configuration;
  system.drive(3, at);
  EXPECT_EQ(at.positions.col(1), Eigen::Vector3d(3, 6, 0));
  EXPECT_EQ(at.positions.col(0), Eigen::Vector3d::Zero());
}

TEST(System, KnowsWhereThePartsOfItsHistoryAre) {
  auto cloth =
      test::cloth_system(test::jittered_grid(0.1, 0.1, 4, 4, 1), test::frictional_cotton());
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  const double* next = state.history.data();
  for (const ShownPotential& shown : cloth.cloth.shown) {
    EXPECT_EQ(cloth.system->history_of(*shown.potential, state), next);
    next += dynamic_cast<const HistoryPotential&>(*shown.potential).history_size();
  }
  EXPECT_EQ(next, state.history.data() + state.history.size());
  const PointForces other(Eigen::Matrix3Xd::Zero(3, 16));
  EXPECT_THROW(cloth.system->history_of(other, state), AssertionError);
}

TEST(System, MayHoldAllOfItsPoints) {
  auto cloth =
      test::cloth_system(test::jittered_grid(0.1, 0.1, 3, 3, 1), test::frictional_cotton());
  for (int i = 0; i < 9; ++i) cloth.system->coordinates().prescribe(i);
  cloth.system->finish();
  const State state = cloth.system->initial_state();
  RandomStream random(1);
  const Configuration at{test::shaken(state.configuration.positions, random, 0.01), {}};
  EXPECT_EQ(test::hessian_of(*cloth.system, at, state).size(), 0);
  EXPECT_EQ(test::reduced_gradient(*cloth.system, at, state).size(), 0);
  EXPECT_GT(test::gradient_of(*cloth.system, at, state).norm(), 0);  // what holds them
}

TEST(PointForces, AreTheNegativeGradientOfTheirEnergy) {
  Eigen::Matrix3Xd forces(3, 2);
  forces << 1, 2, 3, 4, 5, 6;
  System system(points_in_a_row(2), Eigen::VectorXd::Ones(2));
  system.add(std::make_shared<PointForces>(forces));
  system.finish();
  const State state = system.initial_state();
  EXPECT_EQ(test::gradient_of(system, state.configuration, state), -forces);
  EXPECT_DOUBLE_EQ(test::energy_of(system, state.configuration, state).stored, -0.1 * 2);
  EXPECT_EQ(test::hessian_of(system, state.configuration, state).norm(), 0);
}

TEST(PointTargets, PullWithTheirStiffness) {
  Eigen::Matrix3Xd targets = points_in_a_row(2);
  targets.row(2).setConstant(0.3);
  System system(points_in_a_row(2), Eigen::VectorXd::Ones(2));
  system.add(std::make_shared<PointTargets>(Eigen::Vector2d(10, 20), targets));
  system.finish();
  const State state = system.initial_state();
  const Energy energy = test::energy_of(system, state.configuration, state);
  EXPECT_DOUBLE_EQ(energy.stored, 30 * 0.09 / 2);
  EXPECT_EQ(energy.work, 0);
  const Eigen::Matrix3Xd gradient = test::gradient_of(system, state.configuration, state);
  EXPECT_TRUE(gradient.col(0).isApprox(Eigen::Vector3d(0, 0, -3)));
  EXPECT_TRUE(gradient.col(1).isApprox(Eigen::Vector3d(0, 0, -6)));
  Eigen::VectorXd diagonal(6);
  diagonal << 10, 10, 10, 20, 20, 20;
  EXPECT_EQ(test::hessian_of(system, state.configuration, state),
            Eigen::MatrixXd(diagonal.asDiagonal()));
}

/// A point at the origin on a cord of 10 N/m whose end is at (0, 0, 0.5).
struct HungPoint {
  std::shared_ptr<Cord> cord;
  System system{Eigen::Matrix3Xd::Zero(3, 1), Eigen::VectorXd::Ones(1)};

  explicit HungPoint(double length)
      : cord(std::make_shared<Cord>(0, 10, length, Eigen::Vector3d(0, 0, 0.5))) {
    system.add(cord);
    system.finish();
  }
};

TEST(Cord, PullsWithItsStretch) {
  const HungPoint hung(0.2);
  const State state = hung.system.initial_state();
  EXPECT_TRUE(hung.cord->force(state.configuration).isApprox(Eigen::Vector3d(0, 0, 3)));
  EXPECT_NEAR(test::energy_of(hung.system, state.configuration, state).stored, 10 * 0.09 / 2,
              1e-14);
  EXPECT_EQ(test::gradient_of(hung.system, state.configuration, state).col(0),
            -hung.cord->force(state.configuration));
}

TEST(Cord, NeverPushes) {
  const HungPoint hung(0.8);
  const State state = hung.system.initial_state();
  EXPECT_EQ(hung.cord->force(state.configuration), Eigen::Vector3d::Zero());
  EXPECT_EQ(test::energy_of(hung.system, state.configuration, state).stored, 0);
  EXPECT_EQ(test::hessian_of(hung.system, state.configuration, state).norm(), 0);
}

TEST(Cord, HasTheStiffnessOfItsForce) {
  for (const double length : {0.0, 0.2}) {
    const HungPoint hung(length);
    const State state = hung.system.initial_state();
    Configuration at = state.configuration;
    at.positions.col(0) << 0.1, -0.2, 0.05;
    const VectorFunction force = [&](const Eigen::VectorXd& x) {
      return test::reduced_gradient(hung.system, {Eigen::Matrix3Xd(x), {}}, state);
    };
    const DerivativeCheck check =
        check_derivatives(force, test::hessian_of(hung.system, at, state), at.positions.reshaped(),
                          Eigen::Vector3d::Constant(0.05));
    EXPECT_LT(check.error, 1e-9) << check.describe();
  }
}

// A cord without length is a spring to its end: as stiff there as anywhere.
TEST(Cord, WithoutLengthIsStiffAtItsEnd) {
  const HungPoint hung(0);
  const State state = hung.system.initial_state();
  Configuration at = state.configuration;
  at.positions.col(0) << 0, 0, 0.5;
  EXPECT_EQ(hung.cord->force(at), Eigen::Vector3d::Zero());
  EXPECT_EQ(test::hessian_of(hung.system, at, state), 10 * Eigen::Matrix3d::Identity());
}

TEST(Cord, FollowsItsEnd) {
  const HungPoint hung(0.2);
  hung.cord->move_end({0.3, 0, 0});
  EXPECT_TRUE(hung.cord->force(hung.system.initial_state().configuration)
                  .isApprox(Eigen::Vector3d(1, 0, 0)));
}

}  // namespace
}  // namespace pliant
