#include "pliant/render/number_scale.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> labels_of(const NumberScale& scale) {
  std::vector<std::string> labels;
  for (const double tick : scale.ticks) labels.push_back(scale.label(tick));
  return labels;
}

TEST(NumberScale, HasRoundNumbers) {
  EXPECT_THAT(labels_of(number_scale(0, 1, 5)),
              ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels_of(number_scale(-0.013, 0.013, 5)), ElementsAre("-0.01", "0.00", "0.01"));
  EXPECT_THAT(labels_of(number_scale(3, 97, 5)), ElementsAre("20", "40", "60", "80"));
}

TEST(NumberScale, TakesPowersOfAThousandOutOfSmallAndLargeNumbers) {
  const NumberScale small = number_scale(0, 4.2e-6, 5);
  EXPECT_EQ(small.exponent, -6);
  EXPECT_THAT(labels_of(small), ElementsAre("0", "1", "2", "3", "4"));
  EXPECT_EQ(number_scale(0, 2.1e7, 5).exponent, 6);
  EXPECT_EQ(number_scale(-2.1e4, 12, 5).exponent, 0);
}

TEST(NumberScale, OfOneValueHasOneTick) {
  EXPECT_THAT(number_scale(0.25, 0.25, 5).ticks, ElementsAre(0.25));
}

TEST(NumberScale, HasTwoToSixTicksInsideAnyRangeWithDifferentLabels) {
  RandomStream random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    const double size = std::pow(10.0, random.uniform(-9, 9));
    const double low = size * random.uniform(-2, 2);
    const double high = low + size * random.uniform(0.05, 1);
    const NumberScale scale = number_scale(low, high, 5);
    ASSERT_GE(scale.ticks.size(), 2u) << low << " " << high;
    ASSERT_LE(scale.ticks.size(), 6u) << low << " " << high;
    // The ends may be ticks in spite of rounding.
    EXPECT_GE(scale.ticks.front(), low - 1e-8 * (high - low));
    EXPECT_LE(scale.ticks.back(), high + 1e-8 * (high - low));
    EXPECT_NE(scale.label(scale.ticks[0]), scale.label(scale.ticks[1])) << low << " " << high;
  }
}

TEST(Decimals, TellSpacingsApart) {
  EXPECT_EQ(decimals_for(1), 0);
  EXPECT_EQ(decimals_for(20), 0);
  EXPECT_EQ(decimals_for(0.04), 2);
  EXPECT_EQ(decimals_for(0.005), 3);
  EXPECT_EQ(decimals_for(1.0 / 30), 3);
  EXPECT_EQ(decimals_for(1e-9), 6);
}

}  // namespace
}  // namespace pliant
