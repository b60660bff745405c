#include "pliant/contact/obstacle_contact.h"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/contact/barrier.h"
#include "pliant/math/check_derivatives.h"
#include "pliant/mechanics/system.h"

namespace pliant {
namespace {

constexpr double kThickness = 1e-3, kStiffness = 40;
constexpr CoulombFriction kFriction{.sticking = 0.5, .sliding = 0.4};

/// Points at some heights above the top of a ball, far enough apart.
struct Ball {
  static constexpr double kRadius = 0.1;

  explicit Ball(const std::vector<double>& heights) {
    Eigen::Matrix3Xd positions(3, std::ssize(heights));
    std::vector<int> points;
    for (int i = 0; i < positions.cols(); ++i) {
      const double angle = 0.2 * i;
      positions.col(i) = (kRadius + heights[static_cast<size_t>(i)]) *
                         Eigen::Vector3d(std::sin(angle), 0, std::cos(angle));
      points.push_back(i);
    }
    system = std::make_unique<System>(positions, Eigen::VectorXd::Ones(positions.cols()));
    contact = std::make_shared<ObstacleContact>(
        Sphere{Eigen::Vector3d::Zero(), kRadius}, points,
        Eigen::VectorXd::Constant(positions.cols(), kStiffness), kThickness, kFriction, /*body=*/0);
    system->add(contact);
    system->finish();
  }

  std::unique_ptr<System> system;
  std::shared_ptr<ObstacleContact> contact;
};

Configuration moved(const State& state, const Eigen::Vector3d& by) {
  Configuration at = state.configuration;
  at.positions.colwise() += by;
  return at;
}

Eigen::MatrixXd dense(const BlockMatrix& matrix) {
  const Eigen::MatrixXd lower = matrix.lower_triangle();
  return lower.selfadjointView<Eigen::Lower>();
}

TEST(ObstacleContact, HasTheForcesAndTheStiffnessOfItsEnergy) {
  const Ball ball({0.2e-3, 0.4e-3, 0.7e-3, 2e-3});
  const State state = ball.system->initial_state();
  const Conditions under{.from = state};
  // Sticking points, and sliding ones.
  for (const double slip : {0.3e-6, 30e-6}) {
    const Configuration at = moved(state, {slip, 0.7 * slip, 0});
    const auto evaluated = [&](const Eigen::VectorXd& x, Eigen::VectorXd* gradient,
                               Eigen::MatrixXd* stiffness) {
      Configuration there = at;
      there.positions = Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, x.size() / 3);
      Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, there.positions.cols());
      Hessian hessian = ball.system->make_hessian();
      Derivatives derivatives{{}, &forces, &hessian};
      ball.system->evaluate(there, under, Curvature::exact, derivatives);
      if (gradient) *gradient = forces.reshaped();
      if (stiffness) *stiffness = dense(hessian.matrix);
      return derivatives.energy.total();
    };
    const Eigen::VectorXd x = at.positions.reshaped();
    const Eigen::VectorXd scale = Eigen::VectorXd::Constant(x.size(), 0.5 * slip);
    Eigen::VectorXd gradient;
    Eigen::MatrixXd stiffness;
    evaluated(x, &gradient, &stiffness);
    const DerivativeCheck first = check_derivatives(
        [&](const Eigen::VectorXd& y) {
          return Eigen::VectorXd::Constant(1, evaluated(y, nullptr, nullptr));
        },
        gradient.transpose(), x, scale);
    const DerivativeCheck second = check_derivatives(
        [&](const Eigen::VectorXd& y) {
          Eigen::VectorXd forces;
          evaluated(y, &forces, nullptr);
          return forces;
        },
        stiffness, x, scale);
    EXPECT_LT(first.error, 1e-5) << first.describe();
    EXPECT_LT(second.error, 1e-4) << second.describe();
  }
}

TEST(ObstacleContact, StopsEachPointByItselfBeforeTheSurface) {
  const Ball ball({0.5e-3, 20e-3, 0.1e-3});
  const State state = ball.system->initial_state();
  const auto shares = [&](const Eigen::Vector3d& by) {
    return ball.system->way_limits(state.configuration, moved(state, by), {.from = state}, 0.2)
        .shares;
  };
  EXPECT_EQ(shares(Eigen::Vector3d::Zero()), Eigen::Vector3d::Ones());
  EXPECT_EQ(shares({0, 0, 0.3}), Eigen::Vector3d::Ones());
  // A fifth of the distance is kept, or of half the thickness.
  const Eigen::VectorXd near = shares({0, 0, -1e-3});
  EXPECT_NEAR(near(0), 0.4, 1e-3);
  EXPECT_EQ(near(1), 1);
  EXPECT_NEAR(near(2), 0.08, 0.01);
  // Through the ball and out of it again.
  const Eigen::VectorXd through = shares({0, 0, -0.3});
  EXPECT_NEAR(through(0), 0.4e-3 / 0.3, 1e-6);
  EXPECT_NEAR(through(1), 20e-3 / 0.3, 2e-3);
}

TEST(ObstacleContact, CountsTheWaysThatItTests) {
  const Ball ball({0.5e-3, 20e-3, 0.1e-3});
  const State state = ball.system->initial_state();
  SearchCosts costs;
  const Conditions under{.from = state, .costs = &costs};
  ball.system->way_limits(state.configuration, moved(state, {0, 0, -1e-3}), under, 0.2);
  EXPECT_EQ(costs.way_tests, 3);
}

TEST(ObstacleContact, HasInfiniteEnergyInside) {
  const Ball ball({0.5e-3});
  const State state = ball.system->initial_state();
  const auto energy = [&](double by) {
    Derivatives derivatives;
    ball.system->evaluate(moved(state, {0, 0, by}), {.from = state}, Curvature::exact, derivatives);
    return derivatives.energy.stored;
  };
  EXPECT_TRUE(std::isfinite(energy(-0.4e-3)));
  EXPECT_EQ(energy(-0.6e-3), INFINITY);
}

// Loaded below the cone and unloaded again, a slip gives back all it took; what slides is lost.
TEST(ObstacleContact, StoresWhatIsElasticOfASlipAndLosesTheRest) {
  const Ball ball({0.5e-3});
  State state = ball.system->initial_state();
  const auto moved_by = [&](double way) {
    const Configuration at = moved(state, {way, 0, 0});
    Eigen::VectorXd history;
    const Energy energy = ball.system->advance_history(at, {.from = state}, history);
    state.history = history;
    state.configuration = at;
    return energy;
  };
  const double normal = -kStiffness * barrier(0.5e-3, kThickness).slope;
  const double resting = moved_by(0).stored;
  const Energy loaded = moved_by(kSlipLength / 2);
  EXPECT_NEAR(loaded.stored - resting, kFriction.sticking * normal * kSlipLength / 8,
              1e-3 * normal * kSlipLength);
  EXPECT_NEAR(loaded.work, 0, 1e-16);
  const Energy unloaded = moved_by(-kSlipLength / 2);
  EXPECT_NEAR(unloaded.stored, resting, 1e-4 * normal * kSlipLength);
  EXPECT_NEAR(unloaded.work, 0, 1e-16);
  const Energy slid = moved_by(11 * kSlipLength);
  EXPECT_NEAR(slid.work, kFriction.sticking * normal * 10 * kSlipLength,
              1e-3 * normal * kSlipLength);
}

// Else a step that holds still would seem to gain what is elastic of slips.
TEST(ObstacleContact, StoresWhereAStepBeginsWhatTheLastOneLeft) {
  const Ball ball({0.5e-3});
  State state = ball.system->initial_state();
  const Configuration at = moved(state, {kSlipLength / 2, 0, 0});
  Eigen::VectorXd history;
  const Energy left = ball.system->advance_history(at, {.from = state}, history);
  state.history = history;
  state.configuration = at;
  Derivatives begins;
  ball.system->evaluate(at, {.from = state}, Curvature::exact, begins);
  EXPECT_NEAR(begins.energy.total(), left.stored, 1e-14 * left.stored);
  EXPECT_NEAR(begins.energy.work, 0, 1e-18);
}

TEST(ObstacleContact, RemembersWhatIsElasticOfASlip) {
  const Ball ball({0.5e-3});
  State state = ball.system->initial_state();
  const auto force_after = [&](double way) {
    const Configuration at = moved(state, {way, 0, 0});
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, 1);
    Derivatives derivatives{{}, &gradient, nullptr};
    ball.system->evaluate(at, {.from = state}, Curvature::exact, derivatives);
    State next = state;
    ball.system->advance_history(at, {.from = state}, next.history);
    next.configuration = at;
    state = next;
    return gradient(0, 0);
  };
  const double normal = -kStiffness * barrier(0.5e-3, kThickness).slope;
  const double half = force_after(kSlipLength / 2);
  EXPECT_NEAR(half, kFriction.sticking * normal / 2, 1e-4 * normal);
  EXPECT_NEAR(force_after(kSlipLength / 4), 1.5 * half, 1e-4 * normal);
  EXPECT_NEAR(force_after(3 * kSlipLength), kFriction.sticking * normal, 1e-3 * normal);
  // It slides now, and sliding friction is less.
  EXPECT_NEAR(force_after(kSlipLength), kFriction.sliding * normal, 1e-3 * normal);
  // Back by the whole elastic slip: no force is left.
  EXPECT_NEAR(force_after(-kSlipLength), 0, 2e-3 * normal);
}

Controls led_to(const Pose& pose) {
  Controls controls;
  controls.bodies = {pose};
  return controls;
}

// A body that comes pushes who is in its way before it; who goes with it feels no more than before.
TEST(ObstacleContact, OfABodyThatIsLedMakesWayAndGoesAlong) {
  const Ball ball({0.5e-3, 30e-3});
  const State state = ball.system->initial_state();
  const Eigen::Vector3d rise(0, 0, 0.01);
  const Controls led = led_to({Eigen::Quaterniond::Identity(), rise});
  const Conditions under{.from = state, .controls = led};
  const Eigen::Matrix3Xd way = ball.system->made_way(state.configuration.positions, under).value();
  EXPECT_GT(way(2, 0), 0.009);
  EXPECT_TRUE(way.col(1).isZero(0)) << "it is far enough away";
  // A slip of the body below a point at rest rubs as that of the point above it.
  const auto force_at = [&](const Eigen::Vector3d& of_point, const Eigen::Vector3d& of_body) {
    const Controls controls = led_to({Eigen::Quaterniond::Identity(), of_body});
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, 2);
    Derivatives derivatives{{}, &gradient, nullptr};
    ball.system->evaluate(moved(state, of_point), {.from = state, .controls = controls},
                          Curvature::exact, derivatives);
    return Eigen::Vector3d(gradient.col(0));
  };
  const Eigen::Vector3d slip(1e-6, 0, 0), zero = Eigen::Vector3d::Zero();
  EXPECT_TRUE(force_at(slip, zero).isApprox(force_at(zero, -slip), 1e-6));
  EXPECT_TRUE(force_at(rise, rise).isApprox(force_at(zero, zero), 1e-9));
}

// Turned with its points, a body has turned forces and the same energy.
TEST(ObstacleContact, OfABodyThatIsTurnedTurnsItsForcesAndStiffness) {
  const Ball ball({0.4e-3});
  const State state = ball.system->initial_state();
  const Pose turn{Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())),
                  {0.1, 0.2, 0.3}};
  const Controls led = led_to(turn);
  const auto evaluated = [&](const Configuration& at, const Controls& controls,
                             Eigen::Matrix3Xd& gradient, Eigen::MatrixXd& stiffness) {
    gradient = Eigen::Matrix3Xd::Zero(3, 1);
    Hessian hessian = ball.system->make_hessian();
    Derivatives derivatives{{}, &gradient, &hessian};
    ball.system->evaluate(at, {.from = state, .controls = controls}, Curvature::exact, derivatives);
    stiffness = dense(hessian.matrix);
    return derivatives.energy.total();
  };
  const Configuration slid = moved(state, {0.7e-6, 1e-6, 0});
  Configuration turned = slid;
  turned.positions.col(0) = turn.apply(slid.positions.col(0));
  Eigen::Matrix3Xd before, after;
  Eigen::MatrixXd stiffness_before, stiffness_after;
  const double energy = evaluated(slid, kNoControls, before, stiffness_before);
  EXPECT_NEAR(evaluated(turned, led, after, stiffness_after), energy, 1e-9 * energy);
  const Eigen::Matrix3d matrix = turn.rotation.toRotationMatrix();
  EXPECT_TRUE(after.isApprox(matrix * before, 1e-6));
  EXPECT_TRUE(stiffness_after.isApprox(matrix * stiffness_before * matrix.transpose(), 1e-6));
}

TEST(ObstacleContact, ForgetsFrictionWhereAPointHasLeft) {
  const Ball ball({0.5e-3});
  const State state = ball.system->initial_state();
  Eigen::VectorXd history;
  const Configuration away = moved(state, {0, 0, 5e-3});
  const Energy energy = ball.system->advance_history(away, {.from = state}, history);
  EXPECT_EQ(energy.stored, 0);
  EXPECT_NEAR(energy.work, 0, 1e-12);
  EXPECT_TRUE(history.tail(5).isZero());
  EXPECT_NEAR(ball.contact->touching(away.positions, kNoControls).least_distance, 5.5e-3, 1e-12);
}

}  // namespace
}  // namespace pliant
