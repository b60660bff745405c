// A strip bent in a plane: closed forms, balance of what it carries, derivatives, refinement.

#include "pliant/solver/elastica/elastica.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/solver/elastica/equilibria.h"
#include "pliant/solver/elastica/line_factor.h"
#include "pliant/solver/elastica/strip_release.h"

#include "support/published_bending.h"

namespace pliant {
namespace {

using test::PublishedBending;

constexpr double kLength = 0.1;  // m

StripShape straight(const Elastica& strip) {
  StripShape shape;
  shape.curvature = Eigen::VectorXd::Zero(strip.line().size());
  return shape;
}

ComponentLaw elastic(double k1) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(k1);
  return law;
}

TEST(GaussLine, IntegratesPolynomialsExactly) {
  const GaussLine line(2, 3);
  const Eigen::ArrayXd s = line.places();
  const Eigen::VectorXd fifth = s.pow(5);
  EXPECT_NEAR(line.weights().dot(fifth), std::pow(2, 6) / 6, 1e-13);
  EXPECT_NEAR(line.weights().dot(s.pow(11).matrix()), std::pow(2, 12) / 12, 1e-10);
  EXPECT_LT((line.integrals(fifth) - (s.pow(6) / 6).matrix()).cwiseAbs().maxCoeff(), 1e-13);
  for (const double place : {0.0, 0.3, 2.0 / 3, 1.9, 2.0}) {
    EXPECT_NEAR(line.integral_weights(place) * fifth, std::pow(place, 6) / 6, 1e-13) << place;
    EXPECT_NEAR(line.value_weights(place) * fifth, std::pow(place, 5), 1e-12) << place;
  }
}

TEST(GaussLine, KnowsTheGramMatrixOfItsIntegration) {
  const GaussLine line(2, 4);
  const Eigen::VectorXd factors = line.places().array().sin();
  const Eigen::MatrixXd map = line.integrals(Eigen::MatrixXd::Identity(line.size(), line.size()));
  const Eigen::MatrixXd plain = map.transpose() * factors.asDiagonal() * map;
  EXPECT_LT((line.integration_gram(factors) - plain).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LT((line.transposed_integrals(factors) - map.transpose() * factors).norm(), 1e-14);
}

TEST(LineFactor, SolvesWithTheWholeMatrix) {
  const GaussLine line(2, 4);
  const Eigen::VectorXd bending = 1 + line.places().array().square();
  const Eigen::VectorXd turning = line.places().array().cos();  // of both signs
  Eigen::MatrixXd whole = line.integration_gram(turning);
  whole.diagonal() += bending;
  const LineFactor factor(line, bending, turning);
  ASSERT_TRUE(factor.is_positive());
  const Eigen::MatrixXd solution = Eigen::MatrixXd::Random(line.size(), 3);
  EXPECT_LT((factor.solve(whole * solution) - solution).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_FALSE(LineFactor(line, bending, -20 * bending).is_positive());
}

TEST(Elastica, KnowsHowItsTipMovesWithItsLength) {
  const double weight = 2, length = 0.08, step = 1e-5;
  for (const PublishedBending& fabric : test::published_bending()) {
    for (const double clamp : {0.0, 2.5}) {
      StripEnds ends;
      ends.clamp_angle = clamp;
      const auto tip = [&](double at) -> Eigen::Vector2d {
        const Elastica strip(at);
        const auto shape = strip.equilibrium(fabric.law(), weight, ends, strip.rested(fabric.law()),
                                             straight(strip));
        return strip.profile(ends, *shape).at(at).position;
      };
      const Elastica strip(length);
      const StripHistory flat = strip.rested(fabric.law());
      const auto shape = strip.equilibrium(fabric.law(), weight, ends, flat, straight(strip));
      const Eigen::Vector2d difference = (tip(length + step) - tip(length - step)) / (2 * step);
      // Of second order in the step, whose square is 1e-8 of the length's.
      EXPECT_LT((strip.tip_by_length(fabric.law(), weight, ends, flat, *shape) - difference).norm(),
                1e-5)
          << fabric.name << clamp;
    }
  }
}

TEST(Elastica, OfSmallSlopeSagsAsABeamDoes) {
  const Elastica strip(kLength);
  const double k = 1e-3, weight = 1e-3;
  const ComponentLaw law = elastic(k);
  const auto shape = strip.equilibrium(law, weight, {}, strip.rested(law), straight(strip));
  ASSERT_TRUE(shape);
  EXPECT_TRUE(strip.is_stable(law, weight, {}, strip.rested(law), *shape));
  const double sag = weight * std::pow(kLength, 4) / (8 * 3 * k);
  EXPECT_NEAR(strip.profile({}, *shape).at(kLength).position.y(), -sag, 1e-6 * sag);
  const double at_clamp = weight * kLength * kLength / (2 * 3 * k);
  EXPECT_NEAR(strip.profile({}, *shape).at(0).curvature, -at_clamp, 1e-6 * at_clamp);
}

TEST(Elastica, TurnedByAMomentAloneIsAnArc) {
  const Elastica strip(kLength);
  const ComponentLaw law = elastic(2e-5);
  const double angle = 1.5;
  const StripEnds ends{0, angle, {}, {}};
  const auto shape = strip.equilibrium(law, 0, ends, strip.rested(law), straight(strip));
  ASSERT_TRUE(shape);
  EXPECT_NEAR(shape->far_load.z(), 3 * 2e-5 * angle / kLength, 1e-15);
  const Eigen::Vector2d tip = strip.profile(ends, *shape).at(kLength).position;
  EXPECT_NEAR(tip.x(), kLength / angle * std::sin(angle), 1e-12);
  EXPECT_NEAR(tip.y(), kLength / angle * (1 - std::cos(angle)), 1e-12);
}

TEST(Elastica, ClampedAtBothEndsBucklesAtEulersLoad) {
  const Elastica strip(kLength);
  const double k = 2e-5;
  const ComponentLaw law = elastic(k);
  const double nearer = 1e-5;  // of the length
  const StripEnds ends{.far_angle = 0, .far_x = kLength * (1 - nearer), .far_y = 0};
  StripShape guess = straight(strip);
  const double rise = 2 * kLength * std::sqrt(nearer) / std::numbers::pi;
  const Eigen::ArrayXd phase = 2 * std::numbers::pi / kLength * strip.line().places().array();
  guess.curvature = rise / 2 * std::pow(2 * std::numbers::pi / kLength, 2) * phase.cos();
  const auto shape = strip.equilibrium(law, 0, ends, strip.rested(law), guess);
  ASSERT_TRUE(shape);
  EXPECT_TRUE(strip.is_stable(law, 0, ends, strip.rested(law), *shape));
  const double euler = 3 * k * std::pow(2 * std::numbers::pi / kLength, 2);
  EXPECT_NEAR(shape->far_load.x(), -euler, 1e-4 * euler);
  EXPECT_NEAR(shape->far_load.y(), 0, 1e-9 * euler);
}

// The middle of a strip between two clamps is level and free to rise, so that half of it is enough.
TEST(Elastica, HalfAStripWhoseMiddleIsFreeToRisePushesLikeTheWhole) {
  const ComponentLaw law = elastic(2e-5);
  const double weight = 3, distance = 0.8 * kLength;
  const auto force = [&](double length, const StripEnds& ends) {
    const Elastica strip(length);
    StripShape guess = straight(strip);
    guess.curvature = 60 * (2 * std::numbers::pi / kLength * strip.line().places().array()).cos();
    const auto shape = strip.equilibrium(law, weight, ends, strip.rested(law), guess);
    return shape ? shape->far_load.x() : 0.0;
  };
  const double whole = force(kLength, {.far_angle = 0, .far_x = distance, .far_y = 0});
  StripEnds half;
  half.far_angle = 0;
  half.far_x = distance / 2;
  EXPECT_LT(whole, 0);
  // Both to the tolerance of an equilibrium.
  EXPECT_NEAR(force(kLength / 2, half), whole, 1e-7 * std::abs(whole));
}

/// The moment about each point of what hangs beyond it, by other means than the solver's.
double hanging_moment(const Elastica& strip, const StripShape& shape, double weight, double place) {
  const StripProfile profile = strip.profile({}, shape);
  const double x = profile.at(place).position.x();
  const GaussLine rest(kLength - place, 40);
  double moment = 0;
  for (int i = 0; i < rest.size(); ++i) {
    const double there = profile.at(place + rest.places()(i)).position.x();
    moment -= weight * rest.weights()(i) * (there - x);
  }
  return moment;
}

TEST(Elastica, CarriesTheMomentOfWhatHangsOnIt) {
  for (const PublishedBending& fabric : test::published_bending()) {
    const Elastica strip(kLength);
    StripHistory history = strip.rolled(fabric.law(), 1 / 0.01);
    const auto shape = released(strip, fabric.law(), fabric.weight(), {}, false, history);
    ASSERT_TRUE(shape) << fabric.name;
    const double scale = fabric.weight() * kLength * kLength;
    for (int i = 0; i < strip.line().size(); i += 7) {
      const double strain = 3 * shape->curvature(i);
      const FrictionState rolled{3 / 0.01, fabric.law().friction_stress(3 / 0.01, {}).stress};
      const double moment =
          fabric.law().elastic_stress(strain) + fabric.law().friction_stress(strain, rolled).stress;
      EXPECT_NEAR(moment, hanging_moment(strip, *shape, fabric.weight(), strip.line().places()(i)),
                  1e-6 * scale)
          << fabric.name << " " << i;
    }
  }
}

TEST(Elastica, WithoutWeightKeepsTheCurvatureThatFrictionHolds) {
  ComponentLaw law = elastic(2e-5);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {4e-4, 0, 8};
  const Elastica strip(kLength);
  StripHistory history = strip.rolled(law, 300);
  const auto shape = released(strip, law, 0, {}, false, history);
  ASSERT_TRUE(shape);
  for (const double curvature : shape->curvature) EXPECT_NEAR(3 * curvature, 4e-4 / 2e-5, 1e-6);
}

/// Tips of released strips under refinement.
TEST(Elastica, ConvergesUnderRefinement) {
  const PublishedBending felt = test::published_bending()[0];
  const auto tip = [&](int elements) {
    const Elastica strip(kLength, elements);
    StripHistory history = strip.rolled(felt.law(), 1 / 0.005);
    const auto shape = released(strip, felt.law(), felt.weight(), {}, false, history);
    EXPECT_TRUE(shape);
    return strip.profile({}, *shape).at(kLength).position;
  };
  const Eigen::Vector2d fine = tip(48);
  EXPECT_LT((tip(6) - fine).norm(), 1e-7);
  EXPECT_LT((tip(24) - fine).norm(), 1e-9);
}

// A limp strip that leaves its clamp upwards hangs over on either side.
TEST(Equilibria, OfAStripThatLeavesItsClampUpwardsAreMirrored) {
  const Elastica strip(kLength);
  const ComponentLaw law = elastic(2e-6);
  const StripEnds ends{std::numbers::pi / 2, {}, {}, {}};
  const auto all = equilibria_near(strip, law, 2, ends, strip.rested(law), straight(strip), 1.5);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_LT((all[0].curvature + all[1].curvature).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT(strip.profile(ends, all[0]).at(kLength).position.y(), 0);
}

TEST(Equilibria, OfAShortStripAreOne) {
  const Elastica strip(0.03);
  const ComponentLaw law = elastic(2e-5);
  const auto shape = strip.equilibrium(law, 1, {}, strip.rested(law), straight(strip));
  ASSERT_TRUE(shape);
  EXPECT_EQ(equilibria_near(strip, law, 1, {}, strip.rested(law), *shape, 3).size(), 1u);
}

TEST(StripProfile, FindsThePlaceThatIsNearest) {
  const Elastica strip(kLength);
  StripShape arc = straight(strip);
  arc.curvature.setConstant(std::numbers::pi / kLength);  // a half circle about (0, radius)
  const StripProfile profile = strip.profile({}, arc);
  const double radius = kLength / std::numbers::pi;
  for (const double place : {0.0, 0.013, 0.05, 0.09, kLength}) {
    const StripPoint point = profile.at(place);
    const Eigen::Vector2d outwards(point.tangent.y(), -point.tangent.x());
    for (const double off : {-0.5, 0.0, 0.5}) {
      const Eigen::Vector2d target = point.position + off * radius * outwards;
      EXPECT_NEAR(profile.nearest(target, 0.8 * place + 0.01), place, 1e-9) << place << " " << off;
    }
  }
  EXPECT_EQ(profile.nearest({-0.02, 2 * radius}, 0.09), kLength);  // beyond the free end
}

/// What a path gives: the tip of a released strip, or the load on a clamp that came nearer and went
/// back.
struct Outcome {
  Eigen::Vector2d value;
  Eigen::MatrixXd by_parameter;
};

Outcome released_tip(const ComponentLaw& law, double weight) {
  const Elastica strip(kLength);
  StripHistory history = strip.rolled(law, 1 / 0.01);
  const auto shape = released(strip, law, weight, {}, true, history);
  EXPECT_TRUE(shape);
  const StripProfile profile = strip.profile({}, *shape);
  return {profile.at(kLength).position, profile.position_by_parameter(kLength)};
}

Outcome clamp_load(const ComponentLaw& law, double weight) {
  const Elastica strip(kLength);
  StripHistory history = strip.rested(law);
  StripShape shape = straight(strip);
  shape.curvature = -(2 * std::numbers::pi / kLength * strip.line().places().array()).cos() * 20;
  for (const double distance : {0.095, 0.09, 0.08, 0.085, 0.09}) {
    const StripEnds ends{.far_angle = 0, .far_x = distance, .far_y = 0};
    auto next = strip.equilibrium(law, weight, ends, history, shape);
    EXPECT_TRUE(next) << distance;
    strip.differentiate(law, weight, ends, history, *next);
    history = strip.accepted(law, history, *next);
    shape = *next;
  }
  return {shape.far_load.head<2>(), shape.far_load_by_parameter.topRows<2>()};
}

// Forces against the way, there and back: friction opens a loop, and its kinks stop nothing.
TEST(Elastica, FollowsItsClampsThereAndBack) {
  ComponentLaw law = elastic(1e-5);
  law.friction_law = FrictionLaw::dahl;
  law.friction = {1e-4, 0, 20};
  const double length = 0.02;
  const auto loop = [&](int elements, double side) {
    const Elastica strip(length, elements);
    StripHistory history = strip.rested(law);
    StripShape shape = straight(strip);
    shape.curvature =
        side * 30 * (2 * std::numbers::pi / length * strip.line().places().array()).cos();
    std::vector<double> forces;
    for (const double share : {0.998, 0.99, 0.94, 0.85, 0.7, 0.6, 0.7, 0.85, 0.94, 0.98}) {
      const StripEnds ends{.far_angle = 0, .far_x = share * length, .far_y = 0};
      auto next = strip.equilibrium(law, 3, ends, history, shape);
      if (!next) return forces;
      history = strip.accepted(law, history, *next);
      shape = *next;
      forces.push_back(shape.far_load.x());
    }
    return forces;
  };
  for (const double side : {-1.0, 1.0}) {
    const std::vector<double> coarse = loop(6, side), fine = loop(12, side);
    ASSERT_EQ(coarse.size(), 10u);
    ASSERT_EQ(fine.size(), 10u);
    for (size_t i = 0; i < 10; ++i) EXPECT_NEAR(coarse[i], fine[i], 2e-3 * std::abs(fine[i])) << i;
    for (size_t i = 2; i < 5; ++i) EXPECT_LT(fine[i], fine[10 - i] - 0.02) << i;
  }
}

void expect_derivatives(Outcome (*outcome)(const ComponentLaw&, double)) {
  const PublishedBending cloth = test::published_bending()[1];
  const ComponentLaw law = cloth.law();
  const Outcome at = outcome(law, cloth.weight());
  Eigen::VectorXd p(law.parameter_count() + 1);
  p << law.parameters(), cloth.weight();
  ASSERT_EQ(at.by_parameter.cols(), p.size());
  for (int k = 0; k < p.size(); ++k) {
    const double step = 1e-5 * p(k);
    const auto value = [&](double change) {
      Eigen::VectorXd q = p;
      q(k) += change;
      return outcome(law.with_parameters(q), q(q.size() - 1)).value;
    };
    const Eigen::Vector2d difference = (value(step) - value(-step)) / (2 * step);
    EXPECT_LT((difference - at.by_parameter.col(k)).norm(), 1e-4 * difference.norm() + 1e-9) << k;
  }
}

TEST(Elastica, KnowsHowAReleasedShapeDependsOnTheParameters) { expect_derivatives(released_tip); }

TEST(Elastica, KnowsHowTheLoadOfAClampDependsOnTheParameters) { expect_derivatives(clamp_load); }

}  // namespace
}  // namespace pliant
