#include "pliant/estimation/statistics/resolution.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

/// Readings of a load cell in steps, in another unit.
std::vector<double> readings(int count, double range, double step, double unit) {
  RandomStream random(7);
  std::vector<double> column;
  for (int i = 0; i < count; ++i) {
    column.push_back(unit * (step * std::round(random.uniform(0, range) / step)));
  }
  return column;
}

constexpr double kRounding = 1e-6;  // relative; numbers are exact to 1e-16, or 6e-8 where told

TEST(Resolution, IsTheStepOfTheNumbers) {
  EXPECT_NEAR(*resolution_of(readings(200, 5, 0.01, 1)), 0.01, 0.01 * kRounding);
  EXPECT_NEAR(*resolution_of(readings(40, 5, 0.005, 1)), 0.005, 0.005 * kRounding);
}

TEST(Resolution, SurvivesAnotherUnit) {
  const double gram_force = 9.80665e-3;
  EXPECT_NEAR(*resolution_of(readings(200, 500, 0.1, gram_force)), 0.1 * gram_force,
              0.1 * gram_force * kRounding);
}

TEST(Resolution, SurvivesSinglePrecision) {
  std::vector<double> column = readings(200, 5, 0.002, 1);
  for (double& number : column) number = static_cast<double>(static_cast<float>(number));
  // Known to the noise over the range: 5 / 0.002 steps share the rounding of one number.
  EXPECT_NEAR(*resolution_of(column), 0.002, 0.002 * 1e-4);
}

TEST(Resolution, IsNotTheSmallestDistanceWhereThatIsSeveralSteps) {
  EXPECT_NEAR(*resolution_of({0, 2, 5, 11, 14, 20}), 1, kRounding);
}

TEST(Resolution, IsNoneOfNumbersThatAreNotQuantised) {
  RandomStream random(3);
  for (const int count : {5, 12, 200, 2000}) {
    std::vector<double> column;
    for (int i = 0; i < count; ++i) column.push_back(random.uniform(-1, 4));
    EXPECT_FALSE(resolution_of(column)) << count;
  }
}

TEST(Resolution, IsNotTheDistanceOfRows) {
  std::vector<double> column;
  for (int i = 0; i < 50; ++i) column.push_back(0.1 * i);
  EXPECT_FALSE(resolution_of(column));
  // The same numbers, loading and unloading: a coarse instrument does that.
  for (int i = 49; i >= 0; --i) column.push_back(0.1 * i);
  EXPECT_NEAR(*resolution_of(column), 0.1, 0.1 * kRounding);
}

TEST(Resolution, IsNoneOfFewDifferentNumbers) {
  EXPECT_FALSE(resolution_of({1, 2, 4, 1, 2, 4, 1, 2, 4, 7}));
  EXPECT_FALSE(resolution_of({}));
}

TEST(RoundingSd, IsThatOfAUniformDistribution) {
  RandomStream random(1);
  double squares = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) squares += std::pow(random.uniform(-0.5, 0.5), 2);
  // The mean square of 20000 numbers is known to 0.6 %, its root to 0.3 %.
  EXPECT_NEAR(rounding_sd(1), std::sqrt(squares / kCount), 0.01);
}

}  // namespace
}  // namespace pliant
