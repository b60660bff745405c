#include "pliant/measurement/turning_points.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

/// Samples `spacing` apart along the way between turning values, the first of them a sample.
std::vector<double> even_samples(const std::vector<double>& turns, double spacing) {
  std::vector<double> path;
  double next = 0, passed = 0;
  for (size_t leg = 0; leg + 1 < turns.size(); ++leg) {
    const double distance = std::abs(turns[leg + 1] - turns[leg]);
    const double sign = turns[leg + 1] > turns[leg] ? 1 : -1;
    for (; next <= passed + distance; next += spacing) {
      path.push_back(turns[leg] + sign * (next - passed));
    }
    passed += distance;
  }
  return path;
}

void expect_stretch(const HalfCycle& half, int first, int last, int direction, double turn) {
  EXPECT_EQ(half.first, first);
  EXPECT_EQ(half.last, last);
  EXPECT_EQ(half.direction, direction);
  EXPECT_DOUBLE_EQ(half.turn, turn);
}

TEST(TurningPoints, SparseCyclesTurnAtTheirSamples) {
  const std::vector<double> path{0, 2, 5, 3, 1, 4, 6};
  const auto half_cycles = half_cycles_of(path, 0.1);
  ASSERT_EQ(half_cycles.size(), 3U);
  expect_stretch(half_cycles[0], 0, 2, 1, 5);
  expect_stretch(half_cycles[1], 3, 4, -1, 1);
  expect_stretch(half_cycles[2], 5, 6, 1, 6);
}

TEST(TurningPoints, StretchesCoverEverySampleOnce) {
  RandomStream random(1);
  std::vector<double> path{0};
  for (int i = 0; i < 300; ++i) path.push_back(path.back() + random.normal());
  int next = 0;
  int direction = 0;
  for (const HalfCycle& half : half_cycles_of(path, 1.5)) {
    EXPECT_EQ(half.first, next);
    EXPECT_GE(half.last, half.first);
    EXPECT_NE(half.direction, direction);  // they alternate
    direction = half.direction;
    next = half.last + 1;
  }
  EXPECT_EQ(next, static_cast<int>(path.size()));
}

TEST(TurningPoints, ReversalsBelowTheThresholdAreNoise) {
  const std::vector<double> path{0, 1, 0.95, 2, 3, 2.9, 2, 1, 1.08, 0};
  const auto half_cycles = half_cycles_of(path, 0.1);
  ASSERT_EQ(half_cycles.size(), 2U);
  EXPECT_EQ(half_cycles[0].last, 4);
  EXPECT_EQ(half_cycles[1].last, 9);
}

TEST(TurningPoints, NoiseBeforeTheFirstLegIsNoLegOfItsOwn) {
  const auto rising = half_cycles_of(std::vector<double>{0, -0.05, 1, 2, 3}, 0.1);
  ASSERT_EQ(rising.size(), 1U);
  expect_stretch(rising[0], 0, 4, 1, 3);
  const auto falling = half_cycles_of(std::vector<double>{3, 3.05, 2, 1, 0}, 0.1);
  ASSERT_EQ(falling.size(), 1U);
  expect_stretch(falling[0], 0, 4, -1, 0);
}

TEST(TurningPoints, NoiseAfterTheLastTurnIsNoLegOfItsOwn) {
  const auto half_cycles = half_cycles_of(std::vector<double>{0, 1, 2, 3, 2.95}, 0.1);
  ASSERT_EQ(half_cycles.size(), 1U);
  EXPECT_EQ(half_cycles[0].last, 4);
  EXPECT_EQ(half_cycles[0].direction, 1);
}

TEST(TurningPoints, APlateauBelongsToTheStretchBeforeIt) {
  const auto half_cycles = half_cycles_of(std::vector<double>{0, 2, 2, 2, 0}, 0.1);
  ASSERT_EQ(half_cycles.size(), 2U);
  EXPECT_EQ(half_cycles[0].last, 3);
  EXPECT_EQ(half_cycles[1].first, 4);
}

TEST(TurningPoints, TheFirstLegMayFall) {
  const auto half_cycles = half_cycles_of(std::vector<double>{5, 3, 1, 2, 4}, 0.1);
  ASSERT_EQ(half_cycles.size(), 2U);
  expect_stretch(half_cycles[0], 0, 2, -1, 1);
  expect_stretch(half_cycles[1], 3, 4, 1, 4);
}

TEST(TurningPoints, SingleSamplesAndConstantPathsAreOneStretch) {
  for (const std::vector<double>& path : {std::vector<double>{2}, std::vector<double>{2, 2, 2}}) {
    const auto half_cycles = half_cycles_of(path, 0);
    ASSERT_EQ(half_cycles.size(), 1U);
    expect_stretch(half_cycles[0], 0, static_cast<int>(path.size()) - 1, 1, 2);
  }
}

TEST(TurningPoints, ADenseTurnBetweenSamplesIsFoundExactlyForAnEvenSpeed) {
  const std::vector<double> turns{0, 1.234567, 0.2, 1.71828, 0.1};
  for (const double spacing : {0.01, 0.0137, 0.05}) {
    const std::vector<double> path = even_samples(turns, spacing);
    const auto half_cycles = half_cycles_of(path, 0.1);
    ASSERT_EQ(half_cycles.size(), 4U);
    for (size_t i = 0; i + 1 < half_cycles.size(); ++i) {
      EXPECT_NEAR(half_cycles[i].turn, turns[i + 1], 1e-13);  // rounding of the sums of spacings
    }
    EXPECT_EQ(half_cycles.back().turn, path.back());  // nothing tells where it would have turned
  }
}

TEST(TurningPoints, NoisyTurnsLieAtOrALittleBeyondTheExtremeSample) {
  RandomStream random(2);
  for (int draw = 0; draw < 50; ++draw) {
    std::vector<double> path = even_samples({0, random.uniform(1, 2), 0, 1}, 0.02);
    for (double& value : path) value += 0.005 * random.normal();
    const auto half_cycles = half_cycles_of(path, 0.1);
    ASSERT_EQ(half_cycles.size(), 3U);
    for (size_t i = 0; i + 1 < half_cycles.size(); ++i) {
      const HalfCycle& half = half_cycles[i];
      const auto last = static_cast<size_t>(half.last);
      const double s = half.direction;
      const double extreme = std::max(s * path[last], s * path[last + 1]);
      EXPECT_GE(s * half.turn, extreme);
      // Half a step of the speed, which is read off four steps: noise of 0.005 adds
      // 0.005 sqrt(2) / 4 to it, five standard deviations of which are allowed.
      EXPECT_LE(s * half.turn, extreme + (0.02 + 5 * 0.005 * std::sqrt(2.0) / 4) / 2);
    }
  }
}

TEST(TurningPoints, ThresholdIsAShareOfTheRangeOrAMultipleOfTheNoise) {
  const std::vector<double> path{1, 5, 3};
  EXPECT_DOUBLE_EQ(reversal_threshold(path, 0), 0.008);
  EXPECT_DOUBLE_EQ(reversal_threshold(path, 0.001), 0.008);
  EXPECT_DOUBLE_EQ(reversal_threshold(path, 0.01), 0.04);
}

}  // namespace
}  // namespace pliant
