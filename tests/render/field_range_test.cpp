#include "pliant/render/field_range.h"

#include <limits>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// 0, 1, ..., count - 1, shuffled by a step that has no common divisor with `count`.
Eigen::VectorXd shuffled(long count, long step) {
  Eigen::VectorXd values(count);
  for (long i = 0; i < count; ++i) values(i) = static_cast<double>((i * step) % count);
  return values;
}

TEST(FieldRange, LeavesTwoPercentOutOnEachSide) {
  FieldRange range(1);
  range.add(shuffled(101, 37));
  const auto shown = range.shown();
  ASSERT_TRUE(shown.has_value());
  EXPECT_EQ(shown->low, 2);
  EXPECT_EQ(shown->high, 98);
  EXPECT_TRUE(shown->percentiles);
}

TEST(FieldRange, IsOneOfAllFrames) {
  FieldRange range(2);
  range.add(Eigen::Vector2d(0, 3));
  range.add(Eigen::Vector2d(-1, 2));
  EXPECT_EQ(range.shown()->low, -1) << "too few values to leave one out";
  EXPECT_EQ(range.shown()->high, 3);
  EXPECT_FALSE(range.shown()->percentiles);
}

TEST(FieldRange, IsWholeWhereNearlyAllValuesAreOne) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(1000);
  values(17) = 5;
  FieldRange range(1);
  range.add(values);
  EXPECT_EQ(range.shown()->low, 0);
  EXPECT_EQ(range.shown()->high, 5);
  EXPECT_FALSE(range.shown()->percentiles);
}

TEST(FieldRange, LeavesOutWhatIsNotFinite) {
  FieldRange range(1);
  range.add(Eigen::Vector4d(kInfinity, 1, -kInfinity, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(range.shown()->low, 1);
  EXPECT_EQ(range.shown()->high, 1);
  EXPECT_FALSE(FieldRange(1).shown().has_value());
}

TEST(FieldRange, OfManyValuesIsThatOfASampleOfThem) {
  // A hundred times as many as are kept at most: one in 100 of each frame.
  const int vertices = 100'000;
  FieldRange range(4000);
  for (int i = 0; i < 10; ++i) range.add(shuffled(vertices, 37'777));
  // 10,000 values are kept; the 2nd percentile of so many has a standard error of 0.14 %.
  EXPECT_NEAR(range.shown()->low, 0.02 * vertices, 0.005 * vertices);
  EXPECT_NEAR(range.shown()->high, 0.98 * vertices, 0.005 * vertices);
}

}  // namespace
}  // namespace pliant
