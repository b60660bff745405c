#include "pliant/estimation/statistics/robust_loss.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

class EveryLoss : public ::testing::TestWithParam<RobustLoss> {};

TEST_P(EveryLoss, HasItsWeightForASlope) {
  for (const double squared : {0.01, 1.0, 1.8, 3.0, 9.0, 1e4}) {
    const double step = 1e-4 * squared;
    const double slope =
        (rho(GetParam(), squared + step) - rho(GetParam(), squared - step)) / (2 * step);
    EXPECT_NEAR(robust_weight(GetParam(), squared), slope, 1e-6);  // the step squared, and rounding
  }
  EXPECT_EQ(robust_loss_named(name_of(GetParam())), GetParam());
}

TEST_P(EveryLoss, CountsSmallResidualsLikeSquares) {
  EXPECT_NEAR(rho(GetParam(), 1e-4) / 1e-4, 1, 1e-4);
  EXPECT_NEAR(robust_weight(GetParam(), 1e-6), 1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Losses, EveryLoss,
                         ::testing::Values(RobustLoss::none, RobustLoss::huber,
                                           RobustLoss::cauchy));

/// Variance of a location by iterated weights, over that of the mean.
double relative_variance(RobustLoss loss) {
  double squares = 0;
  constexpr int kSeeds = 1500, kRows = 60;
  for (int seed = 0; seed < kSeeds; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    double y[kRows], location = 0;
    for (double& value : y) value = random.normal();
    for (int round = 0; round < 15; ++round) {
      double sum = 0, weights = 0;
      for (const double value : y) {
        const double weight = robust_weight(loss, (value - location) * (value - location));
        sum += weight * value;
        weights += weight;
      }
      location = sum / weights;
    }
    squares += location * location / kSeeds;
  }
  return squares * kRows;
}

TEST(RobustLoss, LosesATwentiethOfNormalData) {
  // The same draws: their ratio is known better than the variances, to about 1 %.
  const double mean = relative_variance(RobustLoss::none);
  EXPECT_NEAR(mean / relative_variance(RobustLoss::huber), 0.95, 0.03);
  EXPECT_NEAR(mean / relative_variance(RobustLoss::cauchy), 0.95, 0.03);
}

TEST(RobustLoss, OfAnUnknownNameIsNone) { EXPECT_FALSE(robust_loss_named("tukey")); }

}  // namespace
}  // namespace pliant
