// Limits of energy as laws of a point: closed forms of the barrier, its multiplier and what it
// hangs on.

#include "pliant/material/density/limited_density.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/material/density/stiffness_density.h"
#include "pliant/material/density/sum.h"

#include "support/density_samples.h"

namespace pliant {
namespace {

constexpr double kStiffness = 40, kLargest = 1.8;  // psi = 20 strain^2 reaches it at 0.3

std::unique_ptr<LimitedDensity> limited(double largest = kLargest) {
  return std::make_unique<LimitedDensity>(
      std::make_shared<StiffnessDensity>(0, ScalarCurve::constant(kStiffness)), largest);
}

test::LaneState at(double strain) {
  test::LaneState state(1, 0);
  state.strain = strain;
  state.last = 0;
  state.before = 0;
  return state;
}

StepTime with(const LimitBarrier& limits) { return {.limits = limits}; }

TEST(LimitedDensity, TakesTheMultiplierThatComplementarityNeeds) {
  for (const double share : {1e-2, 1e-6}) {
    for (const double left : {0.9, 0.1, 1e-3, 1e-6}) {
      if (left < 1e-2 * share) continue;  // multipliers of more than a hundred
      const double strain = std::sqrt(2 * kLargest * (1 - left) / kStiffness);
      const Response response = test::response_of(*limited(), at(strain), with({.share = share}));
      // Rounding of 1 - psi / psi_max.
      const double tolerance = 1e-14 / left;
      const double multiplier = response.stress(0, 0) / (kStiffness * strain) - 1;
      EXPECT_NEAR(multiplier * left, share, tolerance);
      EXPECT_NEAR(response.stored(0), kLargest * (1 - left - share * std::log(left)), tolerance);
    }
  }
}

TEST(LimitedDensity, IsInfiniteAtTheLimitAndBeyond) {
  for (const double strain : {0.3001, -0.3001, 0.31, 2.0}) {
    EXPECT_EQ(test::response_of(*limited(), at(strain)).stored(0), INFINITY) << strain;
  }
  EXPECT_TRUE(std::isfinite(test::response_of(*limited(), at(0.2999)).stored(0)));
}

TEST(LimitedDensity, AMendedBarrierIsSmoothAndLeadsBack) {
  const LimitBarrier mended{.share = 0.1, .mended = 0.2};
  const double joint = std::sqrt(2 * kLargest * 0.8 / kStiffness);
  const Response below = test::response_of(*limited(), at(joint * (1 - 1e-9)), with(mended));
  const Response above = test::response_of(*limited(), at(joint * (1 + 1e-9)), with(mended));
  EXPECT_NEAR(below.stored(0), above.stored(0), 1e-7);
  EXPECT_NEAR(below.stress(0, 0), above.stress(0, 0), 1e-6);
  EXPECT_NEAR(below.tangent(0, 0), above.tangent(0, 0), 1e-5);
  double last = above.stress(0, 0);
  for (double strain = 0.3; strain < 0.6; strain += 0.05) {
    const double stress = test::response_of(*limited(), at(strain), with(mended)).stress(0, 0);
    EXPECT_GT(stress, last);
    last = stress;
  }
}

TEST(LimitedDensity, DerivativesByItsNumbersAreTheirClosedForms) {
  const LimitBarrier limits;
  for (const double left : {0.5, 1e-3, 1e-6}) {
    const double strain = std::sqrt(2 * kLargest * (1 - left) / kStiffness);
    const test::LaneState state = at(strain);
    SampleDerivatives by(1, 0, 2);
    limited()->differentiate(state.samples(), {}, 0, 0, 0, by);
    const double psi = kLargest * (1 - left), m = limits.share;
    const double slope = m / (kLargest * left * left);  // of the multiplier by psi
    const double by_k = strain * (1 + m / left) + slope * kStiffness * strain * psi / kStiffness;
    const double by_limit = -slope * psi / kLargest * kStiffness * strain;
    const double tolerance = 1e-9 + 1e-14 / left;  // relative
    EXPECT_NEAR(by.stress_by_parameter(0, 0), by_k, tolerance * std::abs(by_k));
    EXPECT_NEAR(by.stress_by_parameter(0, 1), by_limit, tolerance * std::abs(by_limit));
    EXPECT_NEAR(by.stored_by_parameter(0), psi / kStiffness * (1 + m / left), tolerance);
    EXPECT_NEAR(by.stored_by_parameter(1), -m * (std::log(left) + (1 - left) / left), tolerance);
  }
}

TEST(LimitedDensity, TellsWhatIsLeft) {
  Sum sum;
  sum.add_addend(limited());
  sum.add_addend(limited(0.9));
  EXPECT_TRUE(sum.is_limited());
  EXPECT_EQ(sum.parameters(), Eigen::Vector4d(kStiffness, kLargest, kStiffness, 0.9));
  for (const double strain : {0.1, -0.2, 0.5}) {
    Lane left = Lane::Constant(INFINITY);
    sum.lower_to_share_left(at(strain).samples(), left);
    EXPECT_NEAR(left(3), 1 - kStiffness / 2 * strain * strain / 0.9, 1e-14);
  }
}

}  // namespace
}  // namespace pliant
