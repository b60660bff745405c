// Where a law snaps while it unloads.

#include "pliant/material/snapping_strains.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/addend_registry.h"

namespace pliant {
namespace {

using testing::IsEmpty;

ComponentLaw rubbing(const ScalarCurve& stiffness, double b) {
  return {stiffness, FrictionLaw::dahl, {1, b, 0.1}};
}

TEST(Snapping, NeverWhereTheTangentExceedsFriction) {
  EXPECT_THAT(snapping_strains(rubbing(ScalarCurve::constant(3), 3), 1), IsEmpty());
  EXPECT_THAT(snapping_strains(rubbing(ScalarCurve::affine(3, 10), 2), 1), IsEmpty());
  EXPECT_THAT(snapping_strains(rubbing(ScalarCurve::hermite({0, 1}, {3, 30}), 2), 1), IsEmpty());
}

TEST(Snapping, EverywhereWhereAConstantStiffnessIsBelowB) {
  const auto intervals = snapping_strains(rubbing(ScalarCurve::constant(3), 4), 1);
  ASSERT_EQ(intervals.size(), 1u);
  EXPECT_EQ(intervals[0].from, 0);
  EXPECT_TRUE(std::isinf(intervals[0].to));
}

TEST(Snapping, FromSomeStrainOnWhereStiffnessFalls) {
  const auto intervals =
      snapping_strains(rubbing(ScalarCurve::affine(5, -2), 3), 1);  // 5 - 4 strain < 3
  ASSERT_EQ(intervals.size(), 1u);
  EXPECT_DOUBLE_EQ(intervals[0].from, 0.5);
  EXPECT_TRUE(std::isinf(intervals[0].to));
}

TEST(Snapping, OfAHermiteCurveEndsWhereTheTangentEqualsB) {
  const ScalarCurve curve = ScalarCurve::hermite({0, 0.1, 0.2, 0.3}, {10, 4, 12, 40});
  const double b = 3;
  const auto intervals = snapping_strains(rubbing(curve, b), 1);
  ASSERT_EQ(intervals.size(), 1u);
  for (const double end : {intervals[0].from, intervals[0].to}) {
    EXPECT_GT(end, 0);
    // The root is bracketed to rounding; the tangent's slope is about 1e3 here.
    EXPECT_NEAR(curve.value(end) + curve.slope(end) * end, b, 1e-10);
  }
  const double middle = (intervals[0].from + intervals[0].to) / 2;
  EXPECT_LT(curve.value(middle) + curve.slope(middle) * middle, b);
}

TEST(Snapping, LooksAtTheSideAskedFor) {
  const ScalarCurve curve = ScalarCurve::hermite({-0.2, 0, 0.2}, {1, 10, 10});
  EXPECT_THAT(snapping_strains(rubbing(curve, 2), 1), IsEmpty());
  EXPECT_EQ(snapping_strains(rubbing(curve, 2), -1).size(), 1u);
}

TEST(Snapping, CountsAllBranchesOfFriction) {
  ComponentLaw law = rubbing(ScalarCurve::constant(3), 2);
  EXPECT_THAT(snapping_strains(law, 1), IsEmpty());
  law.addends = {Addend(*find_addend_kind("dahl"), Eigen::Vector3d(1, 2, 0.5))};
  EXPECT_EQ(snapping_strains(law, 1).size(), 1u);
}

}  // namespace
}  // namespace pliant
