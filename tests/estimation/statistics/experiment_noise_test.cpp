#include "pliant/estimation/statistics/experiment_noise.h"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kRounding = 1e-12;

/// Residuals of alternating sign, which have no correlation length beyond 1.
ExperimentResiduals alternating(int rows, double size, double leverage) {
  ExperimentResiduals experiment;
  experiment.residual = Eigen::VectorXd(rows);
  for (int i = 0; i < rows; ++i) experiment.residual(i) = i % 2 == 0 ? size : -size;
  experiment.series.assign(static_cast<size_t>(rows), 0);
  experiment.leverage = leverage;
  experiment.quantity = "force";
  experiment.range = 100 * size;
  return experiment;
}

TEST(ExperimentNoise, DividesSquaresByTheRowsThatAreSpare) {
  const ExperimentNoise noise = measure_noise({alternating(20, 2, 4)}).front();
  EXPECT_NEAR(noise.sd, std::sqrt(20 * 4.0 / 16), kRounding);
  EXPECT_EQ(noise.source, NoiseSource::residuals);
  EXPECT_EQ(noise.correlation_length, 1);
  EXPECT_EQ(noise.spare_rows, 16);
  EXPECT_EQ(noise.degrees, 16);
}

TEST(ExperimentNoise, OfFewRowsIsThatOfOtherExperimentsOfTheQuantity) {
  ExperimentResiduals few = alternating(2, 1, 1), other = alternating(40, 5, 0);
  other.quantity = "length";
  const auto noise = measure_noise({alternating(20, 2, 4), alternating(30, 1, 2), few, other});
  const double pooled = std::sqrt((20 * 4 + 30 * 1) / 44.0);
  EXPECT_NEAR(noise[2].sd, pooled, kRounding);
  EXPECT_EQ(noise[2].source, NoiseSource::other_experiments);
  EXPECT_TRUE(noise[2].is_assumed());
  EXPECT_EQ(noise[2].degrees, 44);
}

TEST(ExperimentNoise, OfFewRowsAloneIsAHundredthOfTheRange) {
  const ExperimentNoise noise = measure_noise({alternating(3, 1, 2)}).front();
  EXPECT_NEAR(noise.sd, 1, kRounding);
  EXPECT_EQ(noise.source, NoiseSource::measured_range);
  EXPECT_TRUE(noise.is_assumed());
}

TEST(ExperimentNoise, IsNotAssumedAgainstTheResiduals) {
  // Three times the pooled sd in four rows: chi squared 36 of 3, against 7.8 at 95 %.
  const auto noise = measure_noise({alternating(50, 1, 0), alternating(4, 3, 1)});
  EXPECT_EQ(noise[1].source, NoiseSource::few_residuals);
  EXPECT_NEAR(noise[1].sd, std::sqrt(36.0 / 3), kRounding);
  EXPECT_EQ(noise[1].degrees, 3);
}

TEST(ExperimentNoise, FiveSpareRowsAreEnough) {
  EXPECT_FALSE(measure_noise({alternating(7, 1, 2)}).front().is_assumed());
  EXPECT_TRUE(measure_noise({alternating(7, 1, 2.1)}).front().is_assumed());
}

TEST(ExperimentNoise, IsNoFinerThanTheInstrument) {
  ExperimentResiduals experiment = alternating(20, 1e-3, 2);
  experiment.resolution = 0.01;
  const ExperimentNoise noise = measure_noise({experiment}).front();
  EXPECT_NEAR(noise.sd, 0.01 / std::sqrt(12.0), kRounding);
  EXPECT_EQ(noise.source, NoiseSource::resolution);
}

TEST(ExperimentNoise, ThatIsStatedIsAFloor) {
  ExperimentResiduals experiment = alternating(20, 2, 0);
  experiment.stated = 3;
  EXPECT_EQ(measure_noise({experiment}).front().sd, 3);
  EXPECT_TRUE(std::isinf(measure_noise({experiment}).front().degrees));
  experiment.stated = 1;
  EXPECT_NEAR(measure_noise({experiment}).front().sd, 2, kRounding);
  EXPECT_EQ(measure_noise({experiment}).front().source, NoiseSource::residuals);
}

TEST(ExperimentNoise, LeavesOutWhatAnotherChannelExplains) {
  ExperimentResiduals experiment = alternating(20, 5, 0);
  experiment.carried_mean_square = 16;
  EXPECT_NEAR(measure_noise({experiment}).front().sd, 3, kRounding);
}

TEST(ExperimentNoise, OfPerfectDataStillWeighs) {
  ExperimentResiduals experiment = alternating(20, 0, 0);
  experiment.range = 10;
  EXPECT_GT(measure_noise({experiment}).front().sd, 0);
}

TEST(EffectiveRows, AddUpOverExperiments) {
  ExperimentNoise dense, sparse;
  dense.rows = 100, dense.effective_rows = 10, dense.spare_rows = 7;
  sparse.rows = sparse.effective_rows = 5, sparse.spare_rows = 4;
  const EffectiveRows sum = effective_rows({dense, sparse});
  EXPECT_EQ(sum.rows, 105);
  EXPECT_EQ(sum.effective, 15);
  EXPECT_EQ(sum.spare, 11);
}

TEST(RowLeverages, AddUpToTheUnknownsAndLessWithAPrior) {
  Eigen::MatrixXd jacobian(5, 2);
  jacobian << 1, 0, 1, 1, 1, 2, 1, 3, 1, 4;
  const Eigen::MatrixXd slope = jacobian.transpose() * jacobian;
  const Eigen::VectorXd leverage = row_leverages(jacobian, slope.inverse());
  EXPECT_NEAR(leverage.sum(), 2, kRounding);
  EXPECT_NEAR(leverage(0), 0.6, kRounding);  // 1/5 + 2^2/10
  Eigen::MatrixXd with_prior = slope;
  with_prior(0, 0) += 10;
  EXPECT_LT(row_leverages(jacobian, with_prior.inverse()).sum(), 1.9);
  EXPECT_NEAR(row_leverages(jacobian, slope.inverse(), {0, 0}).sum(), 0, kRounding);
}

}  // namespace
}  // namespace pliant
