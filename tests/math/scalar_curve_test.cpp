#include "pliant/math/scalar_curve.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

// Central difference; its error is about step^2 times the third derivative plus rounding / step.
double difference(const std::function<double(double)>& f, double x, double step = 1e-5) {
  return (f(x + step) - f(x - step)) / (2 * step);
}

std::vector<ScalarCurve> curves() {
  return {ScalarCurve::constant(3),
          ScalarCurve::affine(4.42, 32.19),
          ScalarCurve::hermite({0.1, 0.25, 0.7, 0.9}, {10, 12, 40, 35}),
          ScalarCurve::hermite({-0.5, -0.1, 0.3}, {5, 1, 9}),
          ScalarCurve::hermite({0, 0.2, 0.6}, {2, 8, 3}, true),
          ScalarCurve::hermite({0.3}, {7})};
}

const std::vector<double> kPoints{-1.2, -0.45, -0.3, -0.05, 0.07, 0.17, 0.41, 0.83, 1.4};

TEST(ScalarCurve, HermiteInterpolatesItsControlValues) {
  const ScalarCurve curve = ScalarCurve::hermite({0, 0.1, 0.4}, {10, 12, 40});
  EXPECT_DOUBLE_EQ(curve.value(0), 10);
  EXPECT_DOUBLE_EQ(curve.value(0.1), 12);
  EXPECT_DOUBLE_EQ(curve.value(0.4), 40);
}

TEST(ScalarCurve, HermiteTangentsAreCentralDifferencesOneSidedAtTheEnds) {
  const ScalarCurve curve = ScalarCurve::hermite({0, 0.1, 0.4}, {10, 12, 40});
  EXPECT_NEAR(curve.slope(1e-12), 2 / 0.1, 1e-6);
  EXPECT_NEAR(curve.slope(0.1), 30 / 0.4, 1e-9);
  EXPECT_NEAR(curve.slope(0.4 - 1e-12), 28 / 0.3, 1e-6);
}

TEST(ScalarCurve, HermiteReproducesAStraightLineExactly) {
  const ScalarCurve curve = ScalarCurve::hermite({0, 0.05, 0.3, 0.9}, {1, 1.1, 1.6, 2.8});
  for (const double x : {0.01, 0.2, 0.5, 0.89}) EXPECT_NEAR(curve.value(x), 1 + 2 * x, 1e-14);
}

TEST(ScalarCurve, HermiteIsConstantOutsideItsKnots) {
  const ScalarCurve curve = ScalarCurve::hermite({0.1, 0.4}, {10, 40});
  EXPECT_DOUBLE_EQ(curve.value(-3), 10);
  EXPECT_DOUBLE_EQ(curve.value(9), 40);
  EXPECT_DOUBLE_EQ(curve.slope(9), 0);
}

TEST(ScalarCurve, EvenCurvesAreMirrored) {
  const ScalarCurve curve = ScalarCurve::hermite({0, 0.2, 0.6}, {2, 8, 3}, true);
  EXPECT_DOUBLE_EQ(curve.value(-0.3), curve.value(0.3));
  EXPECT_DOUBLE_EQ(curve.slope(-0.3), -curve.slope(0.3));
  EXPECT_DOUBLE_EQ(curve.integral(-0.3), -curve.integral(0.3));
  EXPECT_DOUBLE_EQ(curve.first_moment(-0.3), curve.first_moment(0.3));
}

TEST(ScalarCurve, SlopeIntegralAndFirstMomentAreConsistentWithTheValue) {
  for (const ScalarCurve& curve : curves()) {
    for (const double x : kPoints) {
      SCOPED_TRACE(std::string(name_of(curve.kind())) + " at " + std::to_string(x));
      EXPECT_NEAR(curve.slope(x), difference([&](double t) { return curve.value(t); }, x), 1e-5);
      EXPECT_NEAR(curve.value(x), difference([&](double t) { return curve.integral(t); }, x), 1e-6);
      EXPECT_NEAR(curve.value(x) * x,
                  difference([&](double t) { return curve.first_moment(t); }, x), 1e-6);
    }
    EXPECT_NEAR(curve.integral(0), 0, 1e-15);
    EXPECT_NEAR(curve.first_moment(0), 0, 1e-15);
  }
}

TEST(ScalarCurve, WeightsAreTheDerivativesWithRespectToTheControlValues) {
  for (const ScalarCurve& curve : curves()) {
    for (int i = 0; i < curve.size(); ++i) {
      // Linear in the control values: a unit step gives the weight to rounding.
      std::vector<double> stepped = curve.values();
      stepped[static_cast<size_t>(i)] += 1;
      const ScalarCurve other = curve.with_values(stepped.data());
      for (const double x : kPoints) {
        EXPECT_NEAR(other.value(x) - curve.value(x), curve.weights(x)(i), 1e-12);
        EXPECT_NEAR(other.slope(x) - curve.slope(x), curve.slope_weights(x)(i), 1e-11);
        EXPECT_NEAR(other.integral(x) - curve.integral(x), curve.integral_weights(x)(i), 1e-12);
        EXPECT_NEAR(other.first_moment(x) - curve.first_moment(x), curve.first_moment_weights(x)(i),
                    1e-12);
      }
    }
  }
}

TEST(ScalarCurve, FirstMomentIsTheSumOfItsWeights) {
  for (const ScalarCurve& curve : curves()) {
    const Eigen::Map<const Eigen::VectorXd> values(curve.values().data(), curve.size());
    std::vector<double> points = curve.knots();
    for (int i = -60; i <= 60; ++i) points.push_back(0.025 * i);
    for (const double x : points) {
      const double expected = curve.first_moment_weights(x).dot(values);
      // Rounding of a handful of terms of the size of the curve times x^2, 1.5 at most.
      EXPECT_NEAR(curve.first_moment(x), expected, 1e-13 * 40)
          << name_of(curve.kind()) << " at " << x;
    }
  }
}

TEST(ScalarCurve, RefusesKnotsThatDoNotIncrease) {
  EXPECT_THROW(ScalarCurve::hermite({0, 0.2, 0.2}, {1, 2, 3}), AssertionError);
  EXPECT_THROW(ScalarCurve::hermite({0, 0.2}, {1, 2, 3}), AssertionError);
  EXPECT_THROW(ScalarCurve::hermite({-0.1, 0.2}, {1, 2}, true), AssertionError);
}

}  // namespace
}  // namespace pliant
