#include "pliant/render/sample_table.h"

#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr int kSeeds = 20;

/// Whether the points of a set fall one each into the cells of a grid.
bool one_each(const SampleTable& table, std::uint32_t seed, int columns, int rows) {
  std::set<std::pair<int, int>> cells;
  for (int i = 0; i < columns * rows; ++i) {
    const Eigen::Vector2f point = table.point(seed, static_cast<std::uint32_t>(i));
    cells.emplace(static_cast<int>(point.x() * static_cast<float>(columns)),
                  static_cast<int>(point.y() * static_cast<float>(rows)));
  }
  return std::ssize(cells) == columns * rows;
}

// The property that defines a (0, m, 2)-net in base 2; scrambling and shuffling keep it.
TEST(SampleTable, HasOnePointInEveryElementaryCell) {
  const SampleTable table(16);
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    for (int columns = 1; columns <= 16; columns *= 2) {
      EXPECT_TRUE(one_each(table, seed, columns, 16 / columns)) << seed << ", " << columns;
    }
  }
}

// What lets a pixel take two ambient samples for each camera sample.
TEST(SampleTable, SpreadsEachAlignedBlockEvenlyToo) {
  const SampleTable table(64);
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    EXPECT_TRUE(one_each(table, seed, 4, 4));
  }
}

TEST(SampleTable, StaysInTheUnitSquareAndRepeatsItself) {
  const SampleTable table(9), again(9);
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    for (std::uint32_t i = 0; i < 9; ++i) {
      const Eigen::Vector2f point = table.point(seed, i);
      EXPECT_TRUE((point.array() >= 0).all() && (point.array() < 1).all());
      EXPECT_EQ(point, again.point(seed, i));
    }
  }
}

TEST(SampleTable, GivesAnotherSetForAnotherSeed) {
  const SampleTable table(16);
  EXPECT_NE(table.point(1, 0), table.point(2, 0));
}

TEST(SampleTable, OfOnePointIsNotAlwaysTheSameOne) {
  const SampleTable table(1);
  EXPECT_NE(table.point(1, 0), table.point(2, 0));
}

}  // namespace
}  // namespace pliant
