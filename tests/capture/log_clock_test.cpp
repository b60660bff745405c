#include "pliant/capture/log_clock.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;

constexpr double kRate = 5, kRows = 20;  // frames and rows a second
constexpr double kNoise = 5e-6;          // of a way (m)

/// Still, out to 5 mm in ten seconds, back in ten, still.
double pull(double time) {
  constexpr double kBegin = 4, kSpeed = 0.5e-3, kWay = 5e-3;
  const double there = kSpeed * (time - kBegin);
  return std::max(0.0, std::min(there, 2 * kWay - there));
}

template <class Motion>
ClockLog log_of(const Motion& motion, double seconds) {
  ClockLog log;
  for (int row = 0; row < seconds * kRows; ++row) {
    log.time.push_back(row / kRows);
    log.value.push_back(motion(row / kRows));
  }
  return log;
}

/// What cameras see of it, a little less than the machine says.
template <class Motion>
std::vector<double> ways_of(const Motion& motion, double start, int frames, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<double> ways;
  for (int f = 0; f < frames; ++f) {
    ways.push_back(0.97 * motion(start + f / kRate) + kNoise * random.normal());
  }
  return ways;
}

TEST(LogClock, IsFoundByAPullAndItsReturn) {
  const ClockLog log = log_of(pull, 30);
  int held = 0;
  constexpr int kSeeds = 20;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const double start = 0.7 + 0.13 * seed;
    auto ways = ways_of(pull, start, 120, static_cast<std::uint64_t>(seed));
    ways[30] = NAN;  // a frame that was left out
    const ClockSearch search = find_clock(log, ways, kRate);
    ASSERT_TRUE(search.clock) << search.why;
    EXPECT_NEAR(search.clock->start, start, 0.01);
    EXPECT_LT(search.clock->error, 0.005);
    held += std::abs(search.clock->start - start) < 1.96 * search.clock->error;
  }
  EXPECT_GE(held, 16);
}

TEST(LogClock, MayBeginBeforeTheLog) {
  const ClockLog log = log_of(pull, 30);
  const ClockSearch search = find_clock(log, ways_of(pull, -2, 120, 1), kRate);
  ASSERT_TRUE(search.clock) << search.why;
  EXPECT_NEAR(search.clock->start, -2, 0.01);
}

TEST(LogClock, IsNotGuessedOfASteadyPull) {
  const auto steady = [](double time) { return 1e-4 * time; };
  const ClockLog log = log_of(steady, 30);
  const ClockSearch search = find_clock(log, ways_of(steady, 2, 100, 1), kRate);
  EXPECT_FALSE(search.clock);
}

TEST(LogClock, IsNotGuessedOfCyclesThatAreAlike) {
  const auto cycles = [](double time) { return 1e-3 * (1 - std::cos(time)); };
  const ClockLog log = log_of(cycles, 60);
  const ClockSearch search = find_clock(log, ways_of(cycles, 2, 100, 1), kRate);
  EXPECT_FALSE(search.clock);
  EXPECT_THAT(search.why, HasSubstr("as well as at"));
}

TEST(LogClock, IsNotFoundInAnotherTest) {
  const ClockLog log = log_of(pull, 30);
  const auto other = [](double time) {
    return 1e-3 * std::sin(2 * time) + 1e-3 * std::sin(5 * time);
  };
  const ClockSearch search = find_clock(log, ways_of(other, 2, 120, 1), kRate);
  EXPECT_FALSE(search.clock);
  EXPECT_THAT(search.why, HasSubstr("does not move as the log's extension does"));
}

/// Steps of a second, and a second from each to the next: up, and down again half way.
double step_at(double time) {
  constexpr double kPeriod = 2, kStands = 1, kUp = 6, kAll = 9;
  const auto level = [&](double number) {
    const double within = std::clamp(number, 0.0, kAll);
    return std::min(within, 2 * kUp - within);
  };
  const double number = std::floor(time / kPeriod);
  const double moved =
      std::clamp((time - kPeriod * number - kStands) / (kPeriod - kStands), 0.0, 1.0);
  return level(number) + moved * (level(number + 1) - level(number));
}

/// Of cells that read 2 mN wrongly: 0.1 N a step, more by `growth` times its square.
template <class Motion>
ClockLog log_of_steps(const Motion& step, double growth, double seconds, RandomStream& random) {
  ClockLog log{{}, {}, /*goes_straight=*/false, /*still=*/0.8};
  for (int row = 0; row < seconds * kRows; ++row) {
    const double at = step(row / kRows - 4);
    log.time.push_back(row / kRows);
    log.value.push_back(0.1 * at + growth * at * at + 2e-3 * random.normal());
  }
  return log;
}

// The force grows faster than the way.
TEST(LogClock, IsFoundByForcesThatGoInSteps) {
  constexpr double kFrames = 0.5;
  for (int seed = 0; seed < 10; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    const double start = 4.4 + 0.02 * seed;  // the steps begin at 4 s, and stand for a second
    const ClockLog log = log_of_steps(step_at, 0.02, 28, random);
    std::vector<double> ways;
    for (int f = 0; f < 10; ++f) {
      ways.push_back(1e-3 * step_at(start - 4 + f / kFrames) + kNoise * random.normal());
    }
    const ClockSearch search = find_clock(log, ways, kFrames);
    ASSERT_TRUE(search.clock) << search.why;
    EXPECT_NEAR(search.clock->start, 4.5, 0.05);
    EXPECT_LT(search.clock->error, 0.15);
  }
}

// Even steps up are much alike a step later.
TEST(LogClock, IsNotMistakenByAFrameWhereForcesGoStepByStepUp) {
  constexpr double kFrames = 0.5;
  const auto up = [](double time) {
    const double number = std::floor(time / 2);
    return std::clamp(number + std::clamp(time - 2 * number - 1, 0.0, 1.0), 0.0, 19.0);
  };
  int found = 0;
  for (int seed = 0; seed < 20; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    const ClockLog log = log_of_steps(up, 0.005, 48, random);
    std::vector<double> ways;
    for (int f = 0; f < 20; ++f) {
      ways.push_back(1e-3 * (up(0.5 + f / kFrames) + 0.25 * random.normal()));
    }
    const ClockSearch search = find_clock(log, ways, kFrames);
    if (!search.clock) continue;
    ++found;
    EXPECT_NEAR(search.clock->start, 4.5, 0.2) << seed;
  }
  std::printf("%d of 20 clocks found of noisy steps\n", found);
}

TEST(LogClock, IsNotFoundInALogOfOneRow) {
  const ClockSearch search = find_clock({{1}, {0.1}}, ways_of(pull, 2, 120, 1), kRate);
  EXPECT_FALSE(search.clock);
  EXPECT_THAT(search.why, HasSubstr("shorter than the frames"));
}

TEST(LogClock, IsNotFoundByForcesThatHaveNothingToDoWithTheCords) {
  RandomStream random(4);
  ClockLog log{{}, {}, /*goes_straight=*/false, 0};
  for (int row = 0; row < 28 * kRows; ++row) {
    log.time.push_back(row / kRows);
    log.value.push_back(random.normal());
  }
  const ClockSearch search = find_clock(log, ways_of(pull, 2, 120, 1), kRate);
  EXPECT_FALSE(search.clock);
  EXPECT_THAT(search.why, HasSubstr("what cords pull does not move as the log's force does"));
}

}  // namespace
}  // namespace pliant
