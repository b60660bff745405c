#include "pliant/math/quantiles.h"

#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTable = 5.1e-4;  // tables have three decimals

TEST(StudentQuantile, AgreesWithTheTable) {
  // Two-sided 95 %, e.g. Abramowitz and Stegun, table 26.10.
  const std::vector<std::pair<double, double>> table{{1, 12.706}, {2, 4.303},  {3, 3.182},
                                                     {4, 2.776},  {10, 2.228}, {120, 1.980}};
  for (const auto& [degrees, quantile] : table) {
    EXPECT_NEAR(student_quantile_95(degrees), quantile, kTable) << degrees;
  }
  EXPECT_NEAR(one_sided_student_quantile_95(1), 6.314, kTable);
  EXPECT_NEAR(one_sided_student_quantile_95(20), 1.725, kTable);
}

TEST(StudentQuantile, IsTheNormalOneForInfinitelyManyDegrees) {
  EXPECT_NEAR(student_quantile_95(kInfinity), 1.959963985, 1e-9);
  EXPECT_NEAR(one_sided_student_quantile_95(kInfinity), 1.644853627, 1e-9);
}

TEST(StudentQuantile, TakesFewerDegreesThanOneForOne) {
  EXPECT_EQ(student_quantile_95(0.3), student_quantile_95(1));
}

TEST(ChiSquareQuantile, AgreesWithTheTable) {
  EXPECT_NEAR(chi_square_quantile(0.95, 1), 3.841, kTable);
  EXPECT_NEAR(chi_square_quantile(0.90, 1), 2.706, kTable);
  EXPECT_NEAR(chi_square_quantile(0.95, 10), 18.307, kTable);
}

}  // namespace
}  // namespace pliant
