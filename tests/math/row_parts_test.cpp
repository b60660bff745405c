#include "pliant/math/row_parts.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "math/block_matrices.h"

namespace pliant {
namespace {

std::vector<int> parts_of_rows(const RowParts& parts) {
  std::vector<int> part(parts.rows.size(), -1);
  for (int p = 0; p < 3; ++p) {
    for (int n = parts.begin[static_cast<size_t>(p)]; n < parts.begin[static_cast<size_t>(p) + 1];
         ++n) {
      part[static_cast<size_t>(parts.rows[static_cast<size_t>(n)])] = p;
    }
  }
  return part;
}

TEST(RowParts, LeaveTwoHalvesOfAGridUncoupledAndAFewRowsBetween) {
  constexpr int kNodes = 40;
  const BlockPattern pattern(kNodes * kNodes, test::grid_couplings(kNodes, kNodes));
  const RowParts parts = row_parts(pattern);
  std::vector<int> all = parts.rows;
  std::sort(all.begin(), all.end());
  for (int i = 0; i < pattern.size(); ++i) EXPECT_EQ(all[static_cast<size_t>(i)], i);
  const std::vector<int> part = parts_of_rows(parts);
  for (int i = 0; i < pattern.size(); ++i) {
    for (int k = pattern.row_begin(i); k < pattern.row_end(i); ++k) {
      const int p = part[static_cast<size_t>(i)];
      const int q = part[static_cast<size_t>(pattern.column(k))];
      EXPECT_FALSE(p != q && p < RowParts::kMiddle && q < RowParts::kMiddle) << i;
    }
  }
  EXPECT_EQ(parts.begin[3] - parts.begin[RowParts::kMiddle], kNodes);
}

// The second half is swept from its end, so that both ways lead to the middle.
TEST(RowParts, LeadToTheMiddleFromBothEnds) {
  const BlockPattern pattern(1600, test::grid_couplings(40, 40));
  const RowParts parts = row_parts(pattern);
  const auto begin = parts.rows.begin();
  EXPECT_TRUE(std::is_sorted(begin, begin + parts.begin[1]));
  EXPECT_TRUE(std::is_sorted(begin + parts.begin[1], begin + parts.begin[2], std::greater<>()));
}

TEST(RowParts, ArePlainOrderWhereACutLeavesMuchBetween) {
  std::vector<std::pair<int, int>> far;
  for (int i = 0; i < 2000; ++i) far.emplace_back(i, (i + 1000) % 2000);
  const RowParts parts = row_parts(BlockPattern(2000, far));
  EXPECT_TRUE(std::is_sorted(parts.rows.begin(), parts.rows.end()));
  EXPECT_EQ(parts.begin, (std::array{0, 2000, 2000, 2000}));
}

}  // namespace
}  // namespace pliant
