#include "pliant/material/density/stiffness_density.h"

#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "support/density_samples.h"

namespace pliant {
namespace {

void expect_curve(const ScalarCurve& curve, RandomStream& random) {
  const StiffnessDensity density(0, curve);
  for (int draw = 0; draw < 50; ++draw) {
    test::LaneState state(1, 0);
    for (double& x : state.strain.reshaped()) x = random.uniform(-0.3, 0.3);
    const Response response = test::response_of(density, state);
    for (int i = 0; i < kLanes; ++i) {
      const double x = state.strain(i, 0), k = curve.value(x);
      // Values of the order of 100, over spans of a tenth of the range.
      EXPECT_NEAR(response.stored(i), curve.first_moment(x), 1e-12);
      EXPECT_NEAR(response.stress(i, 0), k * x, 1e-11);
      EXPECT_NEAR(response.tangent(i, 0), k + curve.slope(x) * x, 1e-9);
    }
  }
}

TEST(StiffnessDensity, HasTheEnergyStressAndTangentOfItsCurve) {
  RandomStream random(1);
  expect_curve(ScalarCurve::constant(80), random);
  expect_curve(ScalarCurve::affine(80, 300), random);
  expect_curve(ScalarCurve::hermite({0.0}, {80}, true), random);
  expect_curve(ScalarCurve::hermite({0, 0.02, 0.1, 0.2}, {80, 60, 150, 90}, true), random);
  expect_curve(ScalarCurve::hermite({-0.2, -0.05, 0, 0.1}, {80, 60, 150, 90}), random);
  expect_curve(ScalarCurve::hermite({0.05, 0.1}, {80, 60}, true), random);
  expect_curve(ScalarCurve::spline({-0.2, 0.05, 0.1}, {80, 60, 150}), random);
  expect_curve(ScalarCurve::spline({0, 0.1}, {80, 60}, true), random);
  expect_curve(ScalarCurve::energy({-0.2, -0.05, 0.1, 0.15}, {2, 0.1, 0.3, 1.4}), random);
  expect_curve(ScalarCurve::energy({0.05, 0.2}, {0.1, 2}, true), random);
}

TEST(StiffnessDensity, WithOtherParametersFollowsThem) {
  RandomStream random(2);
  const ScalarCurve curve = ScalarCurve::hermite({0, 0.1, 0.2}, {80, 60, 150}, true);
  const auto density = StiffnessDensity(0, ScalarCurve::hermite({0, 0.1, 0.2}, {1, 2, 3}, true))
                           .with_parameters(Eigen::Vector3d(80, 60, 150));
  test::LaneState state(1, 0);
  for (double& x : state.strain.reshaped()) x = random.uniform(-0.3, 0.3);
  const Response response = test::response_of(*density, state);
  for (int i = 0; i < kLanes; ++i) {
    const double x = state.strain(i, 0);
    EXPECT_NEAR(response.stress(i, 0), curve.value(x) * x, 1e-11);
  }
}

}  // namespace
}  // namespace pliant
