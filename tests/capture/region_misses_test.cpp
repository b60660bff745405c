#include "pliant/capture/region_misses.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(RegionMisses, TellMeanAndScatterOfEachRegion) {
  RegionMisses misses(800, 600);
  misses.add({10, 10}, {0.3, 0.1});
  misses.add({90, 90}, {0.1, -0.1});
  misses.add({799.4, 599.4}, {0, 1});
  const RegionMisses::Region& first = misses.at(0, 0);
  EXPECT_EQ(first.count, 2);
  EXPECT_DOUBLE_EQ(first.mean().x(), 0.2);
  EXPECT_NEAR(first.mean().y(), 0, 1e-15);
  EXPECT_DOUBLE_EQ(first.rms(), std::sqrt(0.12 / 4));
  EXPECT_EQ(misses.at(RegionMisses::kAcross - 1, RegionMisses::kDown - 1).count, 1);
  EXPECT_EQ(misses.at(3, 3).count, 0);
  EXPECT_EQ(misses.whole().count, 3);
}

}  // namespace
}  // namespace pliant
