#include "pliant/base/name_order.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(NameOrder, IsThatOfTheNumbersInNames) {
  const std::vector<std::string> sorted{
      "",     "1.png", "002.png", "2.png", "10.png", "2026-01-09", "2026-01-010", "a",
      "a1b2", "a1b10", "a2b1",    "b",     "left",   "left9.png",  "left10.png",  "left10.png.1"};
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      EXPECT_EQ(comes_before(sorted[i], sorted[j]), i < j) << sorted[i] << ", " << sorted[j];
    }
  }
}

// More digits than a number of the machine has.
TEST(NameOrder, HoldsForNumbersOfAnyLength) {
  EXPECT_TRUE(comes_before("99999999999999999999999", "100000000000000000000000"));
  EXPECT_FALSE(comes_before("100000000000000000000000", "99999999999999999999999"));
}

}  // namespace
}  // namespace pliant
