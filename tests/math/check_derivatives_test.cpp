#include "pliant/math/check_derivatives.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

// Two values of three arguments with scales six orders of magnitude apart.
Eigen::VectorXd values(const Eigen::VectorXd& x) {
  return Eigen::Vector2d(x(0) * std::exp(x(1)), std::sin(x(1)) + 1e12 * x(2) * x(2));
}

Eigen::MatrixXd jacobian(const Eigen::VectorXd& x) {
  Eigen::MatrixXd result(2, 3);
  result << std::exp(x(1)), x(0) * std::exp(x(1)), 0, 0, std::cos(x(1)), 2e12 * x(2);
  return result;
}

const Eigen::Vector3d kPoint(2.0, -0.7, 3e-6);
const Eigen::Vector3d kScale(1.0, 1.0, 1e-6);

// What extrapolated differences can do: rounding of the values over the smallest useful step.
constexpr double kDifferenceAccuracy = 1e-9;

TEST(CheckDerivatives, AcceptsARightJacobianOverArgumentsOfVeryDifferentScale) {
  const DerivativeCheck check = check_derivatives(values, jacobian(kPoint), kPoint, kScale);
  EXPECT_LT(check.error, kDifferenceAccuracy) << check.describe();
}

TEST(CheckDerivatives, PointsAtTheWrongEntry) {
  Eigen::MatrixXd wrong = jacobian(kPoint);
  wrong(1, 2) *= 1.001;
  const DerivativeCheck check = check_derivatives(values, wrong, kPoint, kScale);
  EXPECT_GT(check.error, 1e-4);
  EXPECT_EQ(check.value, 1);
  EXPECT_EQ(check.argument, 2);
  EXPECT_THAT(check.describe(), HasSubstr("d value[1] / d argument[2] is 6006000,"));
}

TEST(CheckDerivatives, AValueThatIsNoNumberIsInfinitelyWrong) {
  Eigen::MatrixXd wrong = jacobian(kPoint);
  wrong(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isinf(check_derivatives(values, wrong, kPoint, kScale).error));
}

TEST(CheckDerivatives, FindsASlopeStatedForAConstant) {
  const auto constant = [](const Eigen::VectorXd&) { return Eigen::VectorXd::Constant(1, 5.0); };
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 3);
  EXPECT_GT(check_derivatives(constant, one, kPoint, kScale).error, 0.5);
  EXPECT_EQ(check_derivatives(constant, 0 * one, kPoint, kScale).error, 0);
}

TEST(CheckDerivatives, RefusesAJacobianOfAnotherSize) {
  EXPECT_THROW(check_derivatives(values, Eigen::MatrixXd::Zero(2, 2), kPoint, kScale),
               AssertionError);
  EXPECT_THROW(check_derivatives(values, jacobian(kPoint), kPoint, Eigen::Vector3d(1, 0, 1)),
               AssertionError);
}

}  // namespace
}  // namespace pliant
