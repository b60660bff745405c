#include "pliant/estimation/statistics/specimens.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/math/quantiles.h"

#include "estimation/statistics/synthetic_fit.h"
#include "support/asked_for.h"

namespace pliant {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-6;  // between_sd^2 is found to 1e-9 of its bracket

TEST(SpecimenSpread, OfExactFitsIsTheirStandardDeviation) {
  const auto spread = specimen_spread({{1, 2, 3, 6}, {0, 0, 0, 0}});
  EXPECT_NEAR(spread->between_sd, std::sqrt(14.0 / 3), kRounding);
  EXPECT_NEAR(spread->mean, 3, kRounding);
  EXPECT_NEAR(spread->mean_sd, std::sqrt(14.0 / 3 / 4), kRounding);
  EXPECT_EQ(spread->degrees, 3);
}

TEST(SpecimenSpread, TakesTheNoiseOfTheFitsOut) {
  const auto spread = specimen_spread({{1, 2, 3, 6}, {1, 1, 1, 1}});
  EXPECT_NEAR(spread->between_sd, std::sqrt(14.0 / 3 - 1), kRounding);
  EXPECT_NEAR(spread->mean_sd, std::sqrt(14.0 / 3 / 4), kRounding);
  EXPECT_EQ(specimen_spread({{1, 2, 3, 6}, {9, 9, 9, 9}})->between_sd, 0);
}

TEST(SpecimenSpread, IsNoneOfOneSpecimenAndZeroOfEqualOnes) {
  EXPECT_FALSE(specimen_spread({{1}, {0.1}}));
  EXPECT_EQ(specimen_spread({{2, 2}, {0, 0.1}})->between_sd, 0);
}

TEST(SpecimenSpread, WeighsBadlyMeasuredSpecimensLess) {
  const auto spread = specimen_spread({{1, 1.1, 5}, {1e-4, 1e-4, 4}});
  EXPECT_LT(spread->mean, 2);  // plain: 2.37
}

/// Specimens that differ by 10 %, each measured with this noise (every second one three times as
/// much where `unequal`), and a joint fit that weighs them by it.
bool joint_fit_holds(int specimens, double noise, bool unequal, bool with_spread,
                     RandomStream& random) {
  SpecimenFits fits;
  double weights = 0, sum = 0;
  for (int i = 0; i < specimens; ++i) {
    const double own = noise * (unequal && i % 2 == 1 ? 3 : 1);
    fits.variance.push_back(own * own);
    fits.value.push_back(1 + 0.1 * random.normal() + own * random.normal());
    weights += 1 / (own * own);
    sum += fits.value.back() / (own * own);
  }
  const auto spread = with_spread ? specimen_spread(fits) : std::nullopt;
  const MeanError error = fabric_mean_error(1 / std::sqrt(weights), kInfinity, spread);
  return std::abs(sum / weights - 1) <= error.half_width;
}

double joint_rate(int specimens, double noise, bool unequal, bool with_spread, int seeds) {
  return test::rate_of(seeds, [&](RandomStream& random) {
    return joint_fit_holds(specimens, noise, unequal, with_spread, random);
  });
}

class SpecimenCount : public ::testing::TestWithParam<int> {};

TEST_P(SpecimenCount, GivesIntervalsOfTheFabricThatHoldItsMean) {
  for (const double noise : {0.02, 0.05, 0.1}) {
    // 95 % of 1000 trials vary by 0.7 %: six of them; fits as noisy as the fabric have the wider of
    // two intervals.
    const double rate = joint_rate(GetParam(), noise, false, true, 1000);
    EXPECT_GE(rate, 0.905) << noise;
    EXPECT_LE(rate, 0.99) << noise;
    EXPECT_GE(joint_rate(GetParam(), noise, true, true, 1000), 0.905) << noise;
  }
}

INSTANTIATE_TEST_SUITE_P(Specimens, SpecimenCount, ::testing::Values(2, 3, 5, 10));

TEST(FabricMean, IsNoBetterKnownThanByTheJointFit) {
  const auto equal = specimen_spread({{2, 2 + 1e-9}, {1, 1}});
  const MeanError error = fabric_mean_error(0.7, 50, equal);
  EXPECT_EQ(error.sd, 0.7);
  EXPECT_EQ(error.degrees, 50);
  EXPECT_NEAR(error.half_width, 0.7 * student_quantile_95(50), kRounding);
}

TEST(SlowStatisticsTables, Specimens) {
  if (!test::makes_figures()) GTEST_SKIP() << "a table of docs/figures";

  fmt::print(
      "specimens that differ by 10 %, noise of each fit: coverage of the joint fit alone, "
      "with the spread, with the spread where every second has three times the noise\n");
  for (const int specimens : {2, 3, 5, 10}) {
    for (const double noise : {0.02, 0.05, 0.1}) {
      fmt::print("{:>2} {:>4.0f} % {:>8.1f} {:>8.1f} {:>8.1f}\n", specimens, 100 * noise,
                 100 * joint_rate(specimens, noise, false, false, 4000),
                 100 * joint_rate(specimens, noise, false, true, 4000),
                 100 * joint_rate(specimens, noise, true, true, 4000));
    }
  }
}

}  // namespace
}  // namespace pliant
