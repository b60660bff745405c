#include "pliant/estimation/statistics/correlation_length.h"

#include <cstdint>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "estimation/statistics/synthetic_fit.h"

namespace pliant {
namespace {

using test::autoregressive_noise;

ResidualSeries series_of(const Eigen::VectorXd& noise) {
  return {noise.data(), noise.data() + noise.size()};
}

/// Of one series with memory; mean over seeds.
double mean_length(int rows, double memory, double leverage, int seeds) {
  double sum = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    sum += correlation_length({series_of(autoregressive_noise(rows, memory, random))}, leverage);
  }
  return sum / seeds;
}

TEST(CorrelationLength, OfIndependentNoiseIsNearlyOne) {
  // A first order that BIC takes by mistake, in one series of forty, adds a fifth each.
  EXPECT_NEAR(mean_length(200, 0, 0, 100), 1, 0.03);
}

TEST(CorrelationLength, OfNoiseThatRemembersTheRowBeforeIsKnown) {
  // (1 + memory) / (1 - memory). The memory of 2000 rows is known to 1.4 %, L to 8 %; a hundred
  // series bring that to 1 %, and half a percent more comes from the bias of one order.
  EXPECT_NEAR(mean_length(2000, 0.5, 0, 100), 3, 0.05 * 3);
  EXPECT_NEAR(mean_length(2000, 0.8, 0, 100), 9, 0.05 * 9);
}

TEST(CorrelationLength, CountsRepeatedNumbersAboutOnce) {
  RandomStream random(1);
  ResidualSeries series;
  for (int i = 0; i < 400; ++i) series.insert(series.end(), 4, random.normal());
  // An autoregression of order 8 at most meets a triangle of correlations to a quarter.
  EXPECT_NEAR(correlation_length({series}, 0), 4, 0.25 * 4);
}

/// Mean over seeds of what is left of noise after a fit of smooth curves.
double mean_fitted_length(const Eigen::MatrixXd& jacobian, double memory, bool told) {
  const Eigen::MatrixXd hat =
      jacobian * (jacobian.transpose() * jacobian).inverse() * jacobian.transpose();
  constexpr int kSeeds = 200;
  double sum = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    const Eigen::VectorXd noise = autoregressive_noise(jacobian.rows(), memory, random);
    const double leverage = told ? static_cast<double>(jacobian.cols()) : 0;
    sum += correlation_length({series_of(noise - hat * noise)}, leverage);
  }
  return sum / kSeeds;
}

TEST(CorrelationLength, PutsBackWhatTheFitTookOutOfTheResiduals) {
  const Eigen::MatrixXd jacobian = test::strip_jacobian(test::strain_cycles(350, 2), 5);
  EXPECT_LT(mean_fitted_length(jacobian, 0.8, false), 0.9 * 9);
  // Bias of an estimate as noisy as this (L of 350 rows is known to 20 %) cannot be told better.
  EXPECT_NEAR(mean_fitted_length(jacobian, 0.8, true), 9, 0.1 * 9);
}

TEST(CorrelationLength, DoesNotJoinSeries) {
  // Each series begins anew: half of the rows of `apart` have no predecessor.
  RandomStream random(3);
  std::vector<ResidualSeries> apart;
  ResidualSeries joined;
  for (int i = 0; i < 200; ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    apart.push_back({sign * (3 + random.normal()), sign * (3 + random.normal())});
    joined.insert(joined.end(), apart.back().begin(), apart.back().end());
  }
  EXPECT_GT(correlation_length(apart, 0), 2 * correlation_length({joined}, 0));
}

TEST(CorrelationLength, IsOneWhereThereIsNothingToTell) {
  EXPECT_EQ(correlation_length({{1, 1, 1, 1, 1, 1, 1}}, 0), 1);
  EXPECT_EQ(correlation_length({ResidualSeries(20, 1.0)}, 13), 1);
  EXPECT_EQ(correlation_length({ResidualSeries(20, 0.0)}, 0), 1);
  EXPECT_EQ(correlation_length({}, 0), 1);
}

TEST(CorrelationLength, IsOneWhereNeighboursAlternate) {
  ResidualSeries series;
  for (int i = 0; i < 40; ++i) series.push_back(i % 2 == 0 ? 1 : -1);
  EXPECT_EQ(correlation_length({series}, 4), 1);
}

TEST(CorrelationLength, LeavesARowToSpare) {
  EXPECT_LE(correlation_length({ResidualSeries(100, 1.0)}, 4), 100.0 / 5);
}

}  // namespace
}  // namespace pliant
