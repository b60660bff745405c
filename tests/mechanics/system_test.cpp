#include "pliant/mechanics/system.h"

#include <memory>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/base/parallel.h"
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

TEST(System, IsConstantOnceFinished) {
  System system(points_in_a_row(2), Eigen::VectorXd::Ones(2));
  system.finish();
  EXPECT_THROW(system.add(std::make_shared<PointForces>(points_in_a_row(2))), AssertionError);
  EXPECT_THROW(system.add_parameters({"k"}, Eigen::VectorXd::Ones(1)), AssertionError);
}

TEST(Controls, PutWhatTheyNameAndLeaveTheRest) {
  System system(points_in_a_row(3), Eigen::VectorXd::Ones(3));
  system.coordinates().prescribe(1);
  system.coordinates().prescribe_axis(2, 1);
  system.finish();
  Configuration at = system.initial_state().configuration;
  Controls controls;
  controls.places = {{1, {3, 6, 1}}, {2, {7, 8, 9}, {false, true, false}}};
  system.coordinates().apply(controls, at);
  EXPECT_EQ(at.positions.col(0), Eigen::Vector3d::Zero());
  EXPECT_EQ(at.positions.col(1), Eigen::Vector3d(3, 6, 1));
  EXPECT_EQ(at.positions.col(2), Eigen::Vector3d(0.2, 8, 0));
}

/// What an evaluation and a step of the cloth give with some of its parameters scaled.
Eigen::VectorXd all_of(const System& system, const Configuration& at, double scale) {
  const std::vector<double>& given = system.parameters().values;
  const Eigen::VectorXd values =
      scale * Eigen::Map<const Eigen::VectorXd>(given.data(), std::ssize(given));
  const Parameters parameters = system.with(values);
  State state = system.initial_state(parameters);
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, system.points());
  Hessian hessian = system.make_hessian();
  Derivatives derivatives{{}, &gradient, &hessian};
  system.evaluate(at, {state, parameters}, Curvature::exact, derivatives);
  Eigen::VectorXd history;
  const double work = system.advance_history(at, {state, parameters}, history).work;
  const std::vector<int> by = system.all_parameters();
  Eigen::MatrixXd by_parameter = Eigen::MatrixXd::Zero(3 * system.points(), std::ssize(by));
  system.add_force_sensitivity(at, {state, parameters}, by,
                               Eigen::MatrixXd::Zero(history.size(), std::ssize(by)), by_parameter);
  const Eigen::VectorXd rows =
      hessian.matrix * Eigen::VectorXd::Ones(system.coordinates().unknowns());
  Eigen::VectorXd all(1 + gradient.size() + rows.size() + history.size() + by_parameter.size());
  all << work, gradient.reshaped(), rows, history, by_parameter.reshaped();
  return all;
}

TEST(System, ServesManyThreadsWithDifferentParametersToTheBitsOfOne) {
  auto cloth = test::cloth_system(test::jittered_grid(0.3, 0.3, 21, 21, 1), test::uneven_cotton());
  cloth.system->coordinates().add_clip({0, 1, 2}, false);
  cloth.system->finish();
  const System& system = *cloth.system;
  RandomStream random(1);
  const Configuration at{test::shaken(system.initial_state().configuration.positions, random, 1e-3),
                         system.initial_state().configuration.clips};
  constexpr int kSets = 24;
  std::vector<Eigen::VectorXd> one(kSets), many(kSets);
  const auto scale = [](int i) { return 1 + 0.01 * i; };
  for (int i = 0; i < kSets; ++i) one[static_cast<size_t>(i)] = all_of(system, at, scale(i));
  parallel_for(kSets, 4,
               [&](int i) { many[static_cast<size_t>(i)] = all_of(system, at, scale(i)); });
  EXPECT_NE(one.front(), one.back());
  for (size_t i = 0; i < kSets; ++i) EXPECT_EQ(many[i], one[i]) << i;
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

TEST(Cord, FollowsItsEndWhereControlsNameIt) {
  const Cord cord(0, 10, 0.2, {0, 0, 0.5}, 1);
  const Configuration at{Eigen::Matrix3Xd::Zero(3, 1), {}};
  Controls controls;
  controls.vectors = Eigen::Matrix3Xd::Zero(3, 2);
  controls.vectors(0, 1) = 0.3;
  EXPECT_TRUE(cord.force(at, controls).isApprox(Eigen::Vector3d(1, 0, 0)));
  EXPECT_TRUE(cord.force(at).isApprox(Eigen::Vector3d(0, 0, 3)));
}

TEST(PointForces, ShareAForceThatComesFromOutside) {
  System system(points_in_a_row(3), Eigen::VectorXd::Ones(3));
  system.add(std::make_shared<PointForces>(0, Eigen::Vector3d(0, 1, 2)));
  system.finish();
  const State state = system.initial_state();
  Controls controls;
  controls.vectors = Eigen::Vector3d(3, 4, 5);
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, 3);
  Derivatives derivatives{{}, &gradient, nullptr};
  system.evaluate(state.configuration, {.from = state, .controls = controls}, Curvature::exact,
                  derivatives);
  EXPECT_EQ(gradient, -Eigen::Vector3d(3, 4, 5) * Eigen::RowVector3d(0, 1, 2));
  EXPECT_DOUBLE_EQ(derivatives.energy.stored, -3 * 0.1 - 6 * 0.2);
  EXPECT_EQ(test::gradient_of(system, state.configuration, state).norm(), 0);
}

}  // namespace
}  // namespace pliant
