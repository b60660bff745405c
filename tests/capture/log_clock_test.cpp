#include "pliant/capture/log_clock.h"

#include <cmath>

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

struct Log {
  std::vector<double> times, extension;
};

template <class Motion>
Log log_of(const Motion& motion, double seconds) {
  Log log;
  for (int row = 0; row < seconds * kRows; ++row) {
    log.times.push_back(row / kRows);
    log.extension.push_back(motion(row / kRows));
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
  const Log log = log_of(pull, 30);
  int held = 0;
  constexpr int kSeeds = 20;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const double start = 0.7 + 0.13 * seed;
    auto ways = ways_of(pull, start, 120, static_cast<std::uint64_t>(seed));
    ways[30] = NAN;  // a frame that was left out
    const ClockSearch search = find_clock(log.times, log.extension, ways, kRate);
    ASSERT_TRUE(search.clock) << search.why;
    EXPECT_NEAR(search.clock->start, start, 0.01);
    EXPECT_LT(search.clock->error, 0.005);
    held += std::abs(search.clock->start - start) < 1.96 * search.clock->error;
  }
  EXPECT_GE(held, 16);
}

TEST(LogClock, MayBeginBeforeTheLog) {
  const Log log = log_of(pull, 30);
  const ClockSearch search = find_clock(log.times, log.extension, ways_of(pull, -2, 120, 1), kRate);
  ASSERT_TRUE(search.clock) << search.why;
  EXPECT_NEAR(search.clock->start, -2, 0.01);
}

TEST(LogClock, IsNotGuessedOfASteadyPull) {
  const auto steady = [](double time) { return 1e-4 * time; };
  const Log log = log_of(steady, 30);
  const ClockSearch search =
      find_clock(log.times, log.extension, ways_of(steady, 2, 100, 1), kRate);
  EXPECT_FALSE(search.clock);
}

TEST(LogClock, IsNotGuessedOfCyclesThatAreAlike) {
  const auto cycles = [](double time) { return 1e-3 * (1 - std::cos(time)); };
  const Log log = log_of(cycles, 60);
  const ClockSearch search =
      find_clock(log.times, log.extension, ways_of(cycles, 2, 100, 1), kRate);
  EXPECT_FALSE(search.clock);
  EXPECT_THAT(search.why, HasSubstr("as well as at"));
}

TEST(LogClock, IsNotFoundInAnotherTest) {
  const Log log = log_of(pull, 30);
  const auto other = [](double time) {
    return 1e-3 * std::sin(2 * time) + 1e-3 * std::sin(5 * time);
  };
  const ClockSearch search = find_clock(log.times, log.extension, ways_of(other, 2, 120, 1), kRate);
  EXPECT_FALSE(search.clock);
  EXPECT_THAT(search.why, HasSubstr("does not move as the log's extension does"));
}

}  // namespace
}  // namespace pliant
