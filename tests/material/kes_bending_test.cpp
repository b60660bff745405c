#include "pliant/material/kes_bending.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/published_bending.h"

namespace pliant {
namespace {

constexpr double kRounding = 1e-12;  // relative, of a few dozen operations

MaterialComponent component(ScalarCurve stiffness, std::optional<DahlParameters> friction = {}) {
  MaterialComponent result;
  result.stiffness = std::move(stiffness);
  if (friction) result.friction = ComponentFriction{*friction, {}};
  return result;
}

TEST(KesBending, OfAnElasticSheetIsItsRigidityWithoutHysteresis) {
  const KesBending kes = kes_bending(component(ScalarCurve::constant(2e-6)));
  EXPECT_NEAR(kes.rigidity, 6e-6, kRounding * 6e-6);
  EXPECT_EQ(kes.hysteresis, 0);
  ASSERT_TRUE(kes.residual_curvature);
  EXPECT_NEAR(*kes.residual_curvature, 0, kRounding);
}

// M = 3 k1 kappa + 9 k2 kappa^2: between 50 and 150 1/m its mean slope is 3 k1 + 1800 k2.
TEST(KesBending, OfAGrowingStiffnessIsTheMeanSlope) {
  const KesBending kes = kes_bending(component(ScalarCurve::affine(2e-6, 7e-9)));
  EXPECT_NEAR(kes.rigidity, 6e-6 + 1800 * 7e-9, kRounding * 1e-5);
}

// With a tau so small that friction is saturated everywhere, it is -+ (a + b eps) - b tau.
TEST(KesBending, OfSaturatedFrictionHasClosedForms) {
  const double k = 8e-6, a = 5e-4, b = 2e-6, tau = 1;
  const KesBending kes =
      kes_bending(component(ScalarCurve::constant(k), DahlParameters{a, b, tau}));
  EXPECT_NEAR(kes.rigidity, 3 * k, kRounding * 3 * k);  // the branches' slopes 3 (k +- b) cancel
  EXPECT_NEAR(kes.hysteresis, 2 * (a + 300 * b), kRounding * kes.hysteresis);
  ASSERT_TRUE(kes.residual_curvature);
  EXPECT_NEAR(*kes.residual_curvature, (a + b * tau) / (k - b) / 3, 1e-9);
}

// For b = 0 the closed loop is a (1 - 2 exp(-(reach +- eps) / tau) / (1 + exp(-2 reach / tau))).
TEST(KesBending, OfSlowFrictionIsThatOfTheClosedLoop) {
  const double k = 8e-6, a = 5e-4, tau = 400, reach = 750;
  const auto unloading = [&](double curvature) {
    const double decay = std::exp(-(reach - 3 * curvature) / tau);
    return -a + 2 * a * decay / (1 + std::exp(-2 * reach / tau));
  };
  const KesBending kes =
      kes_bending(component(ScalarCurve::constant(k), DahlParameters{a, 0, tau}));
  const auto width = [&](double curvature) {
    return -unloading(-curvature) - unloading(curvature);
  };
  EXPECT_NEAR(kes.hysteresis, width(100), kRounding * a);
  const auto mean = [&](double curvature) {
    return (unloading(curvature) - unloading(-curvature)) / 2;
  };
  EXPECT_NEAR(kes.rigidity, 3 * k + (mean(150) - mean(50)) / 100, kRounding * 3 * k);
}

TEST(KesBending, IsTheMeanOfTheTwoSides) {
  MaterialComponent both = component(ScalarCurve::constant(8e-6), DahlParameters{5e-4, 0, 1});
  both.friction->negative = DahlParameters{7e-4, 0, 1};
  EXPECT_NEAR(kes_bending(both).hysteresis, 5e-4 + 7e-4, kRounding * 1e-3);
}

// On the way back from 750 1/m friction falls from a to what the elastic stress takes, 3/4 a, and
// keeps it: within tau ln 8.
TEST(KesBending, KeepsNearlyAllCurvatureWhereFrictionOutweighsElasticity) {
  const KesBending kes =
      kes_bending(component(ScalarCurve::constant(1e-6), DahlParameters{1e-3, 0, 1}));
  ASSERT_TRUE(kes.residual_curvature);
  EXPECT_NEAR(*kes.residual_curvature, (750 - std::log(8)) / 3, 1e-2);
}

TEST(KesBending, HasNoResidualCurvatureWithoutAnyMoment) {
  EXPECT_FALSE(kes_bending(component(ScalarCurve::constant(0))).residual_curvature);
}

// Table 5.2 of [T]: what the materials of the paper would read on the instrument.
TEST(KesBending, OfPublishedMaterialsFollowsTheirSaturatedLaw) {
  for (const test::PublishedBending& fabric : test::published_bending()) {
    const KesBending kes = kes_bending(component(ScalarCurve::affine(fabric.k1, fabric.k2),
                                                 DahlParameters{fabric.a, fabric.b, fabric.tau}));
    // Felt's tau is 30 1/m: 0.5/cm lies five tau behind zero, where b tau changes its sign, and
    // 1.5/cm ten tau before the reversal.
    EXPECT_NEAR(kes.rigidity, 3 * fabric.k1 + 1800 * fabric.k2, 5e-4 * kes.rigidity) << fabric.name;
    EXPECT_NEAR(kes.hysteresis, 2 * (fabric.a + 300 * fabric.b), 5e-4 * kes.hysteresis)
        << fabric.name;
  }
}

}  // namespace
}  // namespace pliant
