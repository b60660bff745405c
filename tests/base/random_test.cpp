#include "pliant/base/random.h"

#include <cmath>

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(RandomStream, IsXoshiro256PlusPlusSeededBySplitMix64) {
  // The generator's reference code with seed 0 of SplitMix64.
  RandomStream stream(0);
  EXPECT_EQ(stream.bits(), 0x53175d61490b23dfULL);
  EXPECT_EQ(stream.bits(), 0x61da6f3dc380d507ULL);
  EXPECT_EQ(stream.bits(), 0x5c0fdf91ec9a7bfcULL);
}

TEST(RandomStream, RepeatsForTheSameSeedOnly) {
  RandomStream a(7);
  RandomStream b(7);
  RandomStream c(8);
  EXPECT_EQ(a.bits(), b.bits());
  EXPECT_NE(a.bits(), c.bits());
}

TEST(RandomStream, SplitDependsOnSeedAndNameOnly) {
  RandomStream a(7);
  const RandomStream b(7);
  a.bits();
  EXPECT_EQ(a.split("noise").bits(), b.split("noise").bits());
  EXPECT_NE(a.split("noise").bits(), b.split("start").bits());
  EXPECT_NE(a.split("noise").bits(), RandomStream(8).split("noise").bits());
  EXPECT_NE(RandomStream(7).split("").bits(), RandomStream(7).bits());
}

TEST(RandomStream, UniformHasTheMomentsOfTheUnitInterval) {
  RandomStream stream(1);
  constexpr int kDraws = 100'000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = stream.uniform();
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    squares += x * x;
  }
  // Four standard errors: sqrt(1/12/n) = 0.0009 and sqrt(4/45/n) = 0.0009.
  EXPECT_NEAR(sum / kDraws, 0.5, 0.004);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.004);
}

TEST(RandomStream, NormalHasTheMomentsAndTailOfTheNormalDistribution) {
  RandomStream stream(2);
  constexpr int kDraws = 100'000;
  double sum = 0.0;
  double squares = 0.0;
  int beyond_two = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = stream.normal();
    sum += x;
    squares += x * x;
    beyond_two += std::abs(x) > 2.0 ? 1 : 0;
  }
  // Four standard errors: 1/sqrt(n), sqrt(2/n), sqrt(p/n) with p = 0.0455.
  EXPECT_NEAR(sum / kDraws, 0.0, 0.013);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.018);
  EXPECT_NEAR(static_cast<double>(beyond_two) / kDraws, 0.0455, 0.0027);
}

}  // namespace
}  // namespace pliant
