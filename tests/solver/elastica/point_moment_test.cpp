// Bent strips whose law has addends that remember.

#include "pliant/solver/elastica/point_moment.h"

#include <gtest/gtest.h>

#include "pliant/material/addend/addend_registry.h"
#include "pliant/math/check_derivatives.h"
#include "pliant/solver/elastica/strip_release.h"

namespace pliant {
namespace {

constexpr double kLength = 0.08, kCurvature = 90;  // m, 1/m
constexpr double kWeight = 1.5;                    // N/m^2

ComponentLaw law_of(FrictionLaw friction, const std::vector<Addend>& addends) {
  ComponentLaw law{ScalarCurve::affine(6e-6, 2e-9), friction, {}};
  if (friction != FrictionLaw::none) law.friction = {2e-4, 1e-6, 12};
  law.addends = addends;
  return law;
}

Addend addend(const char* kind, const Eigen::VectorXd& values) {
  return {*find_addend_kind(kind), values};
}

/// A strip that was rolled up and let go, followed so far that the path of its points is no matter.
std::optional<StripShape> let_go(const ComponentLaw& law, bool with_derivatives = false) {
  const Elastica strip(kLength, 8);
  StripHistory history = strip.rolled(law, kCurvature);
  return released(strip, law, kWeight, {}, with_derivatives, history, 1e-6);
}

// The same friction as friction and as an addend.
TEST(PointMoment, OfABranchThatIsAnAddendIsThatOfFriction) {
  const auto friction = let_go(law_of(FrictionLaw::dahl, {}), true);
  const auto branch =
      let_go(law_of(FrictionLaw::none, {addend("dahl", Eigen::Vector3d(2e-4, 1e-6, 12))}), true);
  ASSERT_TRUE(friction && branch);
  EXPECT_GT(friction->curvature.maxCoeff(), 10);  // it has kept some of it
  EXPECT_LT((friction->curvature - branch->curvature).cwiseAbs().maxCoeff(), 1e-6);
  // Both have the numbers in one order: two of the stiffness, three of friction, the weight.
  const Eigen::MatrixXd &a = friction->curvature_by_parameter, &b = branch->curvature_by_parameter;
  for (Eigen::Index i = 0; i < a.cols(); ++i) {
    EXPECT_LT((a.col(i) - b.col(i)).norm(), 1e-5 * a.col(i).norm()) << i;
  }
}

// The work is that of the moment over the curvature.
TEST(PointMoment, WorkIsTheIntegralOfTheMoment) {
  const ComponentLaw law =
      law_of(FrictionLaw::dahl, {addend("dahl", Eigen::Vector3d(1e-4, 0, 60)),
                                 addend("softening", Eigen::Vector2d(2e-6, 150))});
  const Elastica strip(kLength, 1);
  const StripHistory history = strip.rolled(law, 40);
  const auto at = [&](double curvature) { return point_moment(law, history, 0, curvature, false); };
  constexpr double kStep = 1e-3;
  for (const double curvature : {-5.0, 12.0, 39.0, 55.0, 120.0}) {
    const double slope = (at(curvature + kStep).work - at(curvature - kStep).work) / (2 * kStep);
    EXPECT_NEAR(slope, at(curvature).moment, 1e-6 * std::abs(slope)) << curvature;
    const double tangent =
        (at(curvature + kStep).moment - at(curvature - kStep).moment) / (2 * kStep);
    EXPECT_NEAR(tangent, at(curvature).tangent, 1e-5 * std::abs(tangent)) << curvature;
  }
}

TEST(PointMoment, DerivativesOfAReleaseAreThoseOfDifferences) {
  const ComponentLaw law =
      law_of(FrictionLaw::dahl, {addend("dahl", Eigen::Vector3d(1e-4, 5e-7, 80)),
                                 addend("softening", Eigen::Vector2d(2e-6, 150))});
  const auto shape = let_go(law, true);
  ASSERT_TRUE(shape);
  const VectorFunction curvature = [&](const Eigen::VectorXd& parameters) {
    return let_go(law.with_parameters(parameters))->curvature;
  };
  const Eigen::VectorXd parameters = law.parameters();
  const DerivativeCheck check =
      check_derivatives(curvature, shape->curvature_by_parameter.leftCols(parameters.size()),
                        parameters, 0.01 * parameters);
  // The path is followed to a millionth of a radian.
  EXPECT_LT(check.error, 1e-3) << check.describe();
}

}  // namespace
}  // namespace pliant
