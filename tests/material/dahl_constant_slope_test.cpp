#include "pliant/material/density/dahl_constant_slope.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "material/friction_reference.h"
#include "support/random_laws.h"

namespace pliant {
namespace {

using test::integrate_friction;
using test::log_uniform;
using test::random_strains;

// [T] Eq. 5.1 with gamma = 1.
double integrated(const ConstantSlopeParameters& dahl, double strain, const FrictionState& from) {
  const auto rate = [&](double x, double stress, double s) {
    return dahl.alpha * (1 - s * stress / (dahl.a + dahl.b * std::abs(x)));
  };
  return integrate_friction(rate, from, strain, dahl.a / dahl.alpha / 100);
}

double max_stress(const ConstantSlopeParameters& dahl, double strain) {
  return dahl.a + dahl.b * std::abs(strain);
}

// The integration is wrong by about (1/100)^4 / 120 of the stress.
constexpr double kIntegration = 1e-9;

TEST(DahlConstantSlope, SolvesItsEquationAlongRandomPathsThroughZero) {
  RandomStream random(1);
  for (int path = 0; path < 60; ++path) {
    const ConstantSlopeParameters dahl{random.uniform(0.2, 3), random.uniform(0, 6),
                                       log_uniform(random, 10, 400)};
    FrictionState state;
    for (const double strain : random_strains(random, 8, -0.4, 0.4)) {
      const double stress = friction_stress(dahl, strain, state).stress;
      EXPECT_NEAR(stress, integrated(dahl, strain, state), kIntegration * max_stress(dahl, strain));
      state = {strain, stress};
    }
  }
}

TEST(DahlConstantSlope, WithConstantMaximumIsDahlWithTauOfMaximumOverSlope) {
  RandomStream random(2);
  for (int i = 0; i < 100; ++i) {
    const double a = random.uniform(0.2, 3), alpha = log_uniform(random, 10, 400);
    const FrictionState from{random.uniform(-0.3, 0.3), random.uniform(-a, a)};
    const double strain = random.uniform(-0.3, 0.3);
    const double expected = friction_stress(DahlParameters{a, 0, a / alpha}, strain, from).stress;
    const double stress =
        friction_stress(ConstantSlopeParameters{a, 0, alpha}, strain, from).stress;
    EXPECT_NEAR(stress, expected, 1e-12 * a);  // rounding of the exponent, up to 80
  }
}

TEST(DahlConstantSlope, HasNoJumpWhereItsClosedFormTendsToZeroOverZero) {
  // b -> 0 and alpha -> b; values on both sides of every switch to a series.
  for (const double share : {0.0, 1e-12, 1e-8, 1e-5, 1e-4, 1e-3, 2e-3, 1e-2}) {
    for (const ConstantSlopeParameters& dahl : {ConstantSlopeParameters{2, 40 * share, 40},
                                                ConstantSlopeParameters{2, 6, 6 * (1 + share)},
                                                ConstantSlopeParameters{2, 6, 6 * (1 - share)}}) {
      for (const FrictionState& from : {FrictionState{0.3, 1.5}, FrictionState{0.02, -1.5}}) {
        for (const double strain : {0.01, 0.0201, 0.1, 0.4}) {
          SCOPED_TRACE(::testing::Message() << "b " << dahl.b << ", alpha " << dahl.alpha << ", "
                                            << from.strain << " -> " << strain);
          EXPECT_NEAR(friction_stress(dahl, strain, from).stress, integrated(dahl, strain, from),
                      kIntegration * max_stress(dahl, strain));
        }
      }
    }
  }
}

TEST(DahlConstantSlope, TwoMonotoneStepsAreOne) {
  const ConstantSlopeParameters dahl{0.4, 4.84, 12};
  for (const double end : {-0.3, 0.35}) {
    const FrictionState from{0.1, 0.2};
    const double middle = from.strain + 0.6 * (end - from.strain);
    const double at_middle = friction_stress(dahl, middle, from).stress;
    EXPECT_NEAR(friction_stress(dahl, end, {middle, at_middle}).stress,
                friction_stress(dahl, end, from).stress, 1e-13);  // rounding
  }
}

TEST(DahlConstantSlope, HasTheSlopeAlphaWhereTheStressIsZero) {
  const ConstantSlopeParameters dahl{0.4, 4.84, 12};
  for (const double strain : {0.0, 0.2, -0.3}) {
    // A step of rounding size, so that the slope has not changed on the way.
    EXPECT_NEAR(friction_stress(dahl, strain + 1e-14, {strain, 0}).slope, 12, 1e-9);
    EXPECT_NEAR(friction_stress(dahl, strain - 1e-14, {strain, 0}).slope, 12, 1e-9);
  }
}

}  // namespace
}  // namespace pliant
