#include "pliant/experiment/bending_length/dipping_strip.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "support/published_bending.h"

namespace pliant {
namespace {

using test::published_bending;
using test::PublishedBending;

constexpr double kAngle = 41.5 * std::numbers::pi / 180;
constexpr double kWeight = 2;  // N/m^2

ComponentLaw with_stiffness(const ScalarCurve& stiffness) {
  ComponentLaw law;
  law.stiffness = stiffness;
  return law;
}

// An elastic strip knows one length, (rigidity / weight)^(1/3), so that d log L / d log k = 1/3.
TEST(DippingStrip, OfOneRigidityGrowsLikeItsCubeRoot) {
  const double k = 5e-6;
  const auto strip = dipping_strip(with_stiffness(ScalarCurve::constant(k)), kWeight, kAngle,
                                   {StripFace::up, /*with_derivatives=*/true});
  ASSERT_TRUE(strip);
  EXPECT_NEAR(strip->by_parameter(0) * k / strip->overhang, 1.0 / 3, 1e-8);  // rounding
}

class DippingFabric : public ::testing::TestWithParam<PublishedBending> {};

TEST_P(DippingFabric, IsDifferentiatedThroughTheElasticaAndItsFriction) {
  const ComponentLaw law = GetParam().law();
  const double weight = GetParam().weight();
  for (const StripFace face : {StripFace::up, StripFace::down}) {
    const auto strip = dipping_strip(law, weight, kAngle, {face, /*with_derivatives=*/true});
    ASSERT_TRUE(strip);
    const Eigen::VectorXd parameters = law.parameters();
    ASSERT_EQ(strip->by_parameter.size(), parameters.size());
    for (Eigen::Index i = 0; i < parameters.size(); ++i) {
      const double step = 1e-4 * parameters(i);
      const auto overhang = [&](double by) {
        Eigen::VectorXd moved = parameters;
        moved(i) += by;
        return dipping_strip(law.with_parameters(moved), weight, kAngle, {face})->overhang;
      };
      const double difference = (overhang(step) - overhang(-step)) / (2 * step);
      // Of second order in the step; an overhang is known to 1e-11 of itself.
      const double tolerance = 1e-6 * std::abs(difference) + 1e-11 * strip->overhang / step;
      EXPECT_NEAR(strip->by_parameter(i), difference, tolerance) << i;
    }
  }
}

TEST_P(DippingFabric, ReadsAlikeOnBothFaces) {
  const auto up = dipping_strip(GetParam().law(), GetParam().weight(), kAngle);
  const auto down = dipping_strip(GetParam().law(), GetParam().weight(), kAngle, {StripFace::down});
  ASSERT_TRUE(up && down);
  EXPECT_NEAR(down->overhang, up->overhang, 1e-10 * up->overhang);
  EXPECT_LT(up->edge_curvature, 0);
  EXPECT_NEAR(down->edge_curvature, -up->edge_curvature, 1e-8 * down->edge_curvature);
}

TEST_P(DippingFabric, IsTheSameInAFinerElastica) {
  const auto coarse = dipping_strip(GetParam().law(), GetParam().weight(), kAngle);
  const auto fine = dipping_strip(GetParam().law(), GetParam().weight(), kAngle,
                                  {StripFace::up, /*with_derivatives=*/false, 30});
  ASSERT_TRUE(coarse && fine);
  EXPECT_NEAR(coarse->overhang, fine->overhang, 1e-7 * fine->overhang);
}

INSTANTIATE_TEST_SUITE_P(Of, DippingFabric, ::testing::ValuesIn(published_bending()),
                         [](const auto& instance) { return instance.param.name; });

// Stiff where the curvature is positive: with that face down it hangs further out.
TEST(DippingStrip, OfALawWithTwoSidesReadsEachOfThem) {
  const auto both = [](double right, double left) {
    return with_stiffness(ScalarCurve::hermite({-1e-3, 1e-3}, {right, left}, /*even=*/false));
  };
  const auto overhang = [&](const ComponentLaw& law, StripFace face) {
    return dipping_strip(law, kWeight, kAngle, {face})->overhang;
  };
  const double soft = overhang(both(1e-6, 1e-6), StripFace::up);
  const double stiff = overhang(both(4e-6, 4e-6), StripFace::up);
  EXPECT_NEAR(overhang(both(1e-6, 4e-6), StripFace::up), soft, 1e-6 * soft);
  EXPECT_NEAR(overhang(both(1e-6, 4e-6), StripFace::down), stiff, 1e-6 * stiff);
}

}  // namespace
}  // namespace pliant
