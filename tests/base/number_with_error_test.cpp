#include "pliant/base/number_with_error.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(NumberWithError, IsRoundedToTwoDigitsOfTheError) {
  EXPECT_EQ(number_with_error(3638.8, 168), "3640 +- 170");
  EXPECT_EQ(number_with_error(241.3, 190), "240 +- 190");
  EXPECT_EQ(number_with_error(4.8534, 0.0317), "4.853 +- 0.032");
  EXPECT_EQ(number_with_error(-12.34, 5), "-12.3 +- 5.0");
}

}  // namespace
}  // namespace pliant
