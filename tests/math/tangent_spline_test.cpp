#include "pliant/math/tangent_spline.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/math/check_derivatives.h"
#include "pliant/math/scalar_curve.h"

namespace pliant {
namespace {

const std::vector<double> kKnots{-0.8, -0.1, 0.3, 2};
const Eigen::Vector4d kValues(3, 1, 0.5, 4);

TEST(TangentSpline, HasOneEnergyWithItsStressAndItsTangent) {
  for (const double x : {-1.3, -0.5, -0.05, 0.1, 0.9, 2.6}) {
    const Eigen::VectorXd at = Eigen::VectorXd::Constant(1, x);
    const Eigen::VectorXd scale = Eigen::VectorXd::Constant(1, 0.3);
    const auto number = [](double value) { return Eigen::VectorXd::Constant(1, value); };
    const auto energy = [&](const Eigen::VectorXd& e) {
      return number(spline_energy_weights(kKnots, e(0)).dot(kValues));
    };
    const auto stress = [&](const Eigen::VectorXd& e) {
      return number(spline_stress_weights(kKnots, e(0)).dot(kValues));
    };
    // Differences across a knot see its kink: 1e-6 there, 1e-10 elsewhere; steps are a tenth.
    EXPECT_LT(check_derivatives(energy, stress(at), at, scale / 10).error, 1e-8) << x;
    EXPECT_LT(check_derivatives(stress, number(spline_tangent_weights(kKnots, x).dot(kValues)), at,
                                scale / 10)
                  .error,
              1e-8)
        << x;
  }
}

TEST(TangentSpline, IsFreeOfEnergyAndStressAtZeroWhereverItsKnotsAre) {
  for (const std::vector<double>& knots :
       {kKnots, std::vector<double>{1, 2}, std::vector<double>{-2, -1}, std::vector<double>{0}}) {
    EXPECT_EQ(spline_energy_weights(knots, 0).norm(), 0);
    EXPECT_EQ(spline_stress_weights(knots, 0).norm(), 0);
  }
}

TEST(TangentSpline, AConstantSecondDerivativeIsAQuadraticEnergy) {
  const std::vector<double> knots{-1, 0.5, 3};
  const Eigen::Vector3d values = Eigen::Vector3d::Constant(7);
  for (const double x : {-4.0, -0.3, 0.0, 0.7, 5.0}) {
    EXPECT_NEAR(spline_energy_weights(knots, x).dot(values), 3.5 * x * x, 1e-13);
    EXPECT_NEAR(spline_stress_weights(knots, x).dot(values), 7 * x, 1e-13);
    EXPECT_NEAR(spline_secant_weights(knots, x).dot(values), 7, 1e-13);
    EXPECT_NEAR(spline_secant_slope_weights(knots, x).dot(values), 0, 1e-13);
  }
}

TEST(TangentSpline, ItsSecantIsTheStressOverTheStrainAndHasItsLimitAtZero) {
  for (const double x : {-1.3, -0.05, 1e-9, 0.2, 0.9}) {
    const double secant = spline_secant_weights(kKnots, x).dot(kValues);
    EXPECT_NEAR(secant * x, spline_stress_weights(kKnots, x).dot(kValues), 1e-14);
    const double slope = spline_secant_slope_weights(kKnots, x).dot(kValues);
    EXPECT_NEAR(secant + slope * x, spline_tangent_weights(kKnots, x).dot(kValues), 1e-13);
  }
  EXPECT_NEAR(spline_secant_weights(kKnots, 0).dot(kValues),
              spline_tangent_weights(kKnots, 0).dot(kValues), 1e-15);
}

TEST(TangentSpline, OfAnEvenCurveIsMirrored) {
  const ScalarCurve curve = ScalarCurve::spline({0, 0.5, 1}, {1, 3, 2}, /*even=*/true);
  for (const double x : {0.1, 0.7, 2.0}) {
    EXPECT_EQ(curve.value(-x), curve.value(x));
    EXPECT_EQ(curve.slope(-x), -curve.slope(x));
    EXPECT_EQ(curve.first_moment(-x), curve.first_moment(x));
  }
}

}  // namespace
}  // namespace pliant
