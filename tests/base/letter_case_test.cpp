#include "pliant/base/letter_case.h"

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(LetterCase, OfEnglishAndGermanLettersIsTakenAway) {
  EXPECT_EQ(lower_case("Längenänderung [MM]"), "längenänderung [mm]");
  EXPECT_EQ(lower_case("ÄÖÜß×"), "äöüß×");
  EXPECT_EQ(lower_case("力值"), "力值");
}

TEST(LetterCase, IsAllThatAlikeTextsDifferIn) {
  EXPECT_TRUE(same_letters("Prüfkraft", "PRÜFKRAFT"));
  EXPECT_FALSE(same_letters("Kraft", "Kräfte"));
}

}  // namespace
}  // namespace pliant
