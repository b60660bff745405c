#include "pliant/experiment/loop_metrics.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kLow = 0.02, kStiffness = 50, kFriction = 0.4;

/// Rows of a loop with its path, made branch by branch.
class LoopRows {
 public:
  /// Evenly spaced rows from `from` to `to` with force = stiffness x +- friction.
  LoopRows& branch(double from, double to, double friction = kFriction, int rows = 101) {
    const int direction = to > from ? 1 : -1;
    const int anchor = std::max(0, static_cast<int>(x_.size()) - 1);
    for (int i = 0; i < rows; ++i) {
      const double x = from + (to - from) * i / (rows - 1);
      x_.push_back(x);
      y_.push_back(kStiffness * x + direction * friction);
      path_.strain.push_back(x);
      path_.direction.push_back(direction);
      path_.anchor.push_back(anchor);
      path_.specimen.push_back(specimen_);
    }
    return *this;
  }
  LoopRows& next_specimen() {
    ++specimen_;
    return *this;
  }

  LoopSeries series() const {
    const auto rows = static_cast<Eigen::Index>(x_.size());
    return {Eigen::Map<const Eigen::VectorXd>(x_.data(), rows),
            Eigen::Map<const Eigen::VectorXd>(y_.data(), rows)};
  }
  const MeasuredPath& path() const { return path_; }

 private:
  std::vector<double> x_, y_;
  MeasuredPath path_;
  int specimen_ = 0;
};

TEST(LoopMetrics, OfAParallelogramAreInClosedForm) {
  const double high = 0.1, width = 0.05, length = 0.08;
  const LoopRows loop = LoopRows().branch(kLow, high).branch(high, kLow);
  LoopSeries series = loop.series();
  series.width = width;
  series.length = length;
  const auto metrics = loop_metrics(series, loop.path());
  ASSERT_TRUE(metrics);
  const double reach = high - kLow, middle = (high + kLow) / 2;
  // Straight branches: trapezoids and interpolation are exact but for rounding.
  EXPECT_NEAR(metrics->secant_modulus, kStiffness * reach / width / (reach / length), 1e-9);
  EXPECT_NEAR(metrics->hysteresis_ratio, 2 * kFriction / (kStiffness * middle), 1e-12);
  const double loading = kStiffness * (high * high - kLow * kLow) / 2 + kFriction * reach;
  EXPECT_NEAR(metrics->loop_loss, 2 * kFriction * reach / loading, 1e-12);
}

TEST(LoopMetrics, LeaveOutTheWayToTheOtherSide) {
  const LoopRows back = LoopRows().branch(0, 0.1).branch(0.1, 0);
  const LoopRows through = LoopRows().branch(0, 0.1).branch(0.1, -0.1, kFriction, 201);
  const auto half = loop_metrics(back.series(), back.path());
  const auto whole = loop_metrics(through.series(), through.path());
  ASSERT_TRUE(half && whole);
  EXPECT_NEAR(whole->loop_loss, half->loop_loss, 1e-12);
  EXPECT_NEAR(whole->hysteresis_ratio, half->hysteresis_ratio, 1e-12);
}

TEST(LoopMetrics, AreThoseOfTheCycleOfLargestExtension) {
  const LoopRows loop = LoopRows()
                            .branch(kLow, 0.05, 0.1)
                            .branch(0.05, kLow, 0.1)
                            .branch(kLow, 0.1)
                            .branch(0.1, kLow)
                            .branch(kLow, 0.07, 0.1)
                            .branch(0.07, kLow, 0.1);
  const LoopRows largest = LoopRows().branch(kLow, 0.1).branch(0.1, kLow);
  const auto metrics = loop_metrics(loop.series(), loop.path());
  const auto expected = loop_metrics(largest.series(), largest.path());
  ASSERT_TRUE(metrics && expected);
  EXPECT_NEAR(metrics->hysteresis_ratio, expected->hysteresis_ratio, 1e-12);  // rounding
}

TEST(LoopMetrics, ALoopWithoutFrictionLosesNothing) {
  const LoopRows loop = LoopRows().branch(kLow, 0.1, 0).branch(0.1, kLow, 0);
  const auto metrics = loop_metrics(loop.series(), loop.path());
  ASSERT_TRUE(metrics);
  EXPECT_NEAR(metrics->hysteresis_ratio, 0, 1e-12);  // rounding
  EXPECT_NEAR(metrics->loop_loss, 0, 1e-12);
}

TEST(LoopMetrics, ThereAreNoneWithoutUnloading) {
  const LoopRows loading = LoopRows().branch(kLow, 0.1);
  EXPECT_FALSE(loop_metrics(loading.series(), loading.path()));
  EXPECT_FALSE(unloads(loading.path()));
  // 5 % of the extension is none either.
  const LoopRows little = LoopRows().branch(0, 0.1).branch(0.1, 0.095);
  EXPECT_FALSE(loop_metrics(little.series(), little.path()));
  EXPECT_FALSE(unloads(little.path()));
}

TEST(LoopMetrics, APairOfBranchesBelongsToOneSpecimen) {
  const LoopRows two = LoopRows().branch(kLow, 0.1).next_specimen().branch(0.1, kLow);
  EXPECT_FALSE(loop_metrics(two.series(), two.path()));
}

TEST(LoopMetrics, UnloadingByATenthShowsFriction) {
  EXPECT_TRUE(unloads(LoopRows().branch(0, 0.1).branch(0.1, 0.085).path()));
  EXPECT_TRUE(unloads(LoopRows().branch(0, 0.1).branch(0.1, 0).path()));
}

}  // namespace
}  // namespace pliant
