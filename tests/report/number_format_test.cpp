#include "pliant/report/number_format.h"

#include <limits>

#include <gtest/gtest.h>

namespace pliant::report {
namespace {

TEST(FormatSignificant, KeepsTrailingZerosThatAreSignificant) {
  EXPECT_EQ(format_significant(36.04, 3), "36.0");
  EXPECT_EQ(format_significant(0.0314159, 3), "0.0314");
  EXPECT_EQ(format_significant(0.0, 3), "0");
}

TEST(FormatSignificant, RoundsToTheLeftOfTheDecimalPoint) {
  EXPECT_EQ(format_significant(12345.0, 2), "12000");
}

TEST(FormatSignificant, CountsDigitsAfterRounding) {
  EXPECT_EQ(format_significant(9.996, 3), "10.0");
}

TEST(FormatSignificant, WritesBendingStiffnessesWithAPowerOfTen) {
  EXPECT_EQ(format_significant(6.2e-6, 2), "6.2 × 10⁻⁶");
  EXPECT_EQ(format_significant(-3.0e12, 1), "-3 × 10¹²");
}

TEST(FormatSignificant, ShowsADashForWhatIsNoNumber) {
  EXPECT_EQ(format_significant(std::nullopt, 3), kNoValue);
  EXPECT_EQ(format_significant(std::numeric_limits<double>::infinity(), 3), kNoValue);
}

TEST(FormatPercent, HasOneDecimalBelowTen) {
  EXPECT_EQ(format_percent(1.24), "1.2 %");
  EXPECT_EQ(format_percent(9.96), "10 %");
  EXPECT_EQ(format_percent(31.4), "31 %");
}

TEST(FormatPercent, DoesNotShowASmallErrorAsZero) {
  EXPECT_EQ(format_percent(0.01), "< 0.1 %");
  EXPECT_EQ(format_percent(0.0), "0.0 %");
}

TEST(UncertainFormat, LeavesTheStandardErrorTwoDigits) {
  const UncertainFormat format(4.41234, 0.0312);
  EXPECT_EQ(format(4.41234), "4.412");
  EXPECT_EQ(format(0.0312), "0.031");
}

TEST(UncertainFormat, RoundsAValueWithALargeError) {
  const UncertainFormat format(12345.0, 1234.0);
  EXPECT_EQ(format(12345.0), "12300");
  EXPECT_EQ(format(1234.0), "1200");
}

TEST(UncertainFormat, UsesOnePowerOfTenForValueAndError) {
  const UncertainFormat format(6.2134e-6, 3.1e-8);
  EXPECT_EQ(format(6.2134e-6), "6.213 × 10⁻⁶");
  EXPECT_EQ(format(3.1e-8), "0.031 × 10⁻⁶");
}

TEST(UncertainFormat, ShowsFourDigitsWithoutAnError) {
  EXPECT_EQ(UncertainFormat(0.088, std::nullopt)(0.088), "0.08800");
}

}  // namespace
}  // namespace pliant::report
