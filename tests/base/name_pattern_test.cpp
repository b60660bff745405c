#include "pliant/base/name_pattern.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(NamePattern, MatchesAnyTextAtTheirStars) {
  EXPECT_TRUE(matches("*-2cm", "warp-stretch-2cm"));
  EXPECT_TRUE(matches("warp*", "warp"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("*a*b*", "xaybz"));
  EXPECT_TRUE(matches("*ab", "aab"));  // the first "a" is not the right one
  EXPECT_TRUE(matches("exact", "exact"));
  EXPECT_FALSE(matches("exact", "exactly"));
  EXPECT_FALSE(matches("*-2cm", "warp-8cm"));
  EXPECT_FALSE(matches("", "x"));
  EXPECT_FALSE(matches("w?rp", "warp"));  // no other wildcards
}

}  // namespace
}  // namespace pliant
