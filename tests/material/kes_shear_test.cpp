#include "pliant/material/kes_shear.h"

#include <cmath>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kRounding = 1e-12;

MaterialComponent component(double stiffness, std::optional<DahlParameters> friction = {}) {
  MaterialComponent result;
  result.stiffness = ScalarCurve::constant(stiffness);
  if (friction) result.friction = ComponentFriction{*friction, {}};
  return result;
}

double slope_of_sine() {
  return (std::sin(kKesSlopeAngle[1]) - std::sin(kKesSlopeAngle[0])) /
         (kKesSlopeAngle[1] - kKesSlopeAngle[0]);
}

TEST(KesShear, OfAnElasticSheetIsItsStiffnessWithoutHysteresis) {
  const KesShear kes = kes_shear(component(40));
  EXPECT_NEAR(kes.rigidity, 40 * slope_of_sine(), kRounding * 40);
  EXPECT_NEAR(kes.hysteresis, 0, kRounding);
  EXPECT_NEAR(kes.hysteresis_at_five, 0, kRounding);
}

// With a tau so small that friction is saturated everywhere the loop is 2 (a + b eps) wide.
TEST(KesShear, OfSaturatedFrictionIsTwiceItWide) {
  const double a = 1.5, b = 4;
  const KesShear kes = kes_shear(component(40, DahlParameters{a, b, 1e-4}));
  EXPECT_NEAR(kes.rigidity, 40 * slope_of_sine(), 1e-9 * 40);
  EXPECT_NEAR(kes.hysteresis, 2 * (a + b * std::sin(kKesHysteresisAngle[0])), 1e-9);
  EXPECT_NEAR(kes.hysteresis_at_five, 2 * (a + b * std::sin(kKesHysteresisAngle[1])), 1e-9);
}

}  // namespace
}  // namespace pliant
