#include "pliant/estimation/statistics/outliers.h"

#include <limits>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Outliers, AreRowsBeyondFiveStandardDeviationsFarthestFirst) {
  Eigen::VectorXd residual(5), leverage = Eigen::VectorXd::Zero(5);
  residual << 1, -5.5, 4.9, 8, 0;
  const auto found = outliers(residual, leverage, kInfinity);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].row, 3);
  EXPECT_EQ(found[1].row, 1);
  EXPECT_DOUBLE_EQ(found[1].in_sd, -5.5);
}

// A row that pulls the fit to itself leaves a smaller residual.
TEST(Outliers, CountTheLeverageOfTheRow) {
  const Eigen::VectorXd residual = Eigen::VectorXd::Constant(1, 4);
  EXPECT_TRUE(outliers(residual, Eigen::VectorXd::Constant(1, 0.2), kInfinity).empty());
  EXPECT_EQ(outliers(residual, Eigen::VectorXd::Constant(1, 0.5), kInfinity).size(), 1U);
  EXPECT_TRUE(outliers(residual, Eigen::VectorXd::Ones(1), kInfinity).empty());
}

// One of ten rows that is off by 30 sd makes the scatter ten times as large.
TEST(Outliers, AreFoundInAScatterThatTheyMakeThemselves) {
  RandomStream random(2);
  Eigen::VectorXd residual(10);
  for (double& r : residual) r = random.normal();
  residual(4) = 30;
  residual /= std::sqrt(residual.squaredNorm() / 10);
  EXPECT_LT(residual(4), 5);
  const auto found = outliers(residual, Eigen::VectorXd::Zero(10), 10);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].row, 4);
}

TEST(Outliers, AreNoneInNormalNoise) {
  RandomStream random(4);
  Eigen::VectorXd residual(20000);
  for (double& r : residual) r = random.normal();
  EXPECT_TRUE(outliers(residual, Eigen::VectorXd::Zero(20000), kInfinity).empty());
}

}  // namespace
}  // namespace pliant
