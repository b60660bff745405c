#include "pliant/estimation/statistics/determination.h"

#include <cmath>

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(Determination, GoesByTheHalfWidthOverTheValue) {
  EXPECT_EQ(determination_of(50, 4.9, 10), Determination::within_10_percent);
  EXPECT_EQ(determination_of(-50, 5.1, 10), Determination::within_30_percent);
  EXPECT_EQ(determination_of(50, 15.1, 10), Determination::weak);
  EXPECT_EQ(determination_of(50, 50.1, 10), Determination::none);
}

TEST(Determination, OfAValueNearZeroGoesByItsScale) {
  EXPECT_EQ(determination_of(0, 0.09, 10), Determination::within_10_percent);
  EXPECT_EQ(determination_of(0.01, 0.29, 10), Determination::within_30_percent);
  EXPECT_EQ(determination_of(0, 0.9, 10), Determination::weak);
  EXPECT_EQ(determination_of(0.5, 1.1, 10), Determination::none);
}

TEST(Determination, IsNoneWithoutAnInterval) {
  EXPECT_EQ(determination_of(1, NAN, 1), Determination::none);
  EXPECT_EQ(name_of(Determination::none), "not determined");
}

}  // namespace
}  // namespace pliant
