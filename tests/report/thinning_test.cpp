#include "pliant/report/thinning.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

std::vector<double> wave(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(std::sin(0.01 * static_cast<double>(i)));
  }
  return values;
}

TEST(ThinForDrawing, KeepsAShortSeriesWhole) {
  const std::vector<double> values = {3, 1, 2};
  EXPECT_THAT(thin_for_drawing(values, {}, 10), ElementsAre(0, 1, 2));
}

TEST(ThinForDrawing, KeepsASinglePeakOfALongSeries) {
  std::vector<double> values = wave(100'000);
  values[54'321] = 7.0;
  values[12'345] = -7.0;
  const auto kept = thin_for_drawing(values, {}, 1000);
  EXPECT_THAT(kept, Contains(54'321));
  EXPECT_THAT(kept, Contains(12'345));
}

TEST(ThinForDrawing, KeepsTheEndsAndTheReversals) {
  const std::vector<double> values = wave(10'000);
  const std::vector<std::size_t> reversals = {4'003, 7'777};
  const auto kept = thin_for_drawing(values, reversals, 100);
  for (const std::size_t row : {0, 4'003, 7'777, 9'999}) EXPECT_THAT(kept, Contains(row));
}

TEST(ThinForDrawing, StaysWithinItsBudget) {
  const std::vector<std::size_t> reversals = {10, 20, 30};
  const auto kept = thin_for_drawing(wave(10'000), reversals, 100);
  EXPECT_LE(kept.size(), 105u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  EXPECT_EQ(std::adjacent_find(kept.begin(), kept.end()), kept.end());
}

TEST(ThinForDrawing, IgnoresReversalsBeyondTheBudget) {
  std::vector<std::size_t> all(10'000);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  EXPECT_LE(thin_for_drawing(wave(10'000), all, 100).size(), 102u);
}

}  // namespace
}  // namespace pliant::report
