#include "pliant/experiment/bending_length/bending_length.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/quantity.h"
#include "pliant/material/addend/addend_registry.h"

#include "support/published_bending.h"

namespace pliant {
namespace {

using test::published_bending;
using test::PublishedBending;

ComponentLaw elastic(double k1) {
  ComponentLaw law;
  law.stiffness = ScalarCurve::constant(k1);
  return law;
}

double peirce(double rigidity, double area_density) {
  return std::cbrt(rigidity / (area_density * kStandardGravity));
}

// The heavy elastica dips by 41.5 degrees at weight overhang^3 / rigidity = 8.0042.
TEST(BendingLength, OfAnElasticStripIsPeircesWithin2In10000) {
  for (const double k1 : {1e-7, 2e-6, 5e-4}) {
    const auto result = bending_length(elastic(k1), 0.2);
    ASSERT_TRUE(result) << k1;
    const double expected = peirce(3 * k1, 0.2);
    EXPECT_NEAR(result->length, expected * std::cbrt(8.0042) / 2, 1e-5 * expected) << k1;
    EXPECT_NEAR(result->length, expected, 2e-4 * expected) << k1;
    EXPECT_EQ(result->overhang, 2 * result->length);
    EXPECT_NEAR(result->flexural_rigidity, 3 * k1, 6e-4 * 3 * k1) << k1;
  }
}

// Peirce's own formula, c = l (cos(angle / 2) / (8 tan angle))^(1/3), is good to 2 % up to there.
TEST(BendingLength, FollowsPeircesFormulaAtOtherAngles) {
  for (const double degrees : {10.0, 25.0, 41.5}) {
    const double angle = degrees * std::numbers::pi / 180;
    const auto result = bending_length(elastic(5e-6), 0.15, angle);
    ASSERT_TRUE(result);
    const double by_formula =
        result->overhang * std::cbrt(std::cos(angle / 2) / (8 * std::tan(angle)));
    EXPECT_NEAR(by_formula, peirce(3 * 5e-6, 0.15), 0.02 * by_formula) << degrees;
  }
}

TEST(BendingLength, FrictionMakesAStripReadStiffer) {
  for (const PublishedBending& fabric : published_bending()) {
    ComponentLaw smooth = fabric.law();
    smooth.friction_law = FrictionLaw::none;
    const auto with = bending_length(fabric.law(), fabric.density);
    const auto without = bending_length(smooth, fabric.density);
    ASSERT_TRUE(with && without) << fabric.name;
    EXPECT_GT(with->length, without->length) << fabric.name;
  }
}

// Small angles: a light cantilever, tan(angle) = weight overhang^3 / (8 B).
TEST(ElasticDip, OfASmallAngleIsTheBeams) {
  const double angle = 1e-3;
  const auto dip = elastic_dip(angle);
  ASSERT_TRUE(dip);
  // The next term is of order angle^2.
  EXPECT_NEAR(std::pow(dip->overhang_per_length, 3), 8 * std::tan(angle), 1e-5 * 8 * angle);
  // Moment weight L^2 / 2 at the edge: curvature times overhang = weight L^3 / (2 B).
  EXPECT_NEAR(dip->edge_turn, 4 * angle, 1e-5 * 4 * angle);
}

TEST(BendingLengthSpread, IsThatOfTheReadings) {
  const double per_length = elastic_dip(kOverhangAngle)->overhang_per_length;
  const double weight = 1.5;
  const auto spread = bending_length_spread({0.048, 0.052}, kOverhangAngle, weight);
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->readings, 2);
  EXPECT_NEAR(spread->length, 0.05 / per_length, 1e-15);
  EXPECT_NEAR(*spread->length_variation, std::sqrt(2) * 0.002 / 0.05, 1e-12);
  EXPECT_NEAR(spread->flexural_rigidity, weight * std::pow(0.05 / per_length, 3), 1e-15);
  const double low = std::pow(0.048, 3), high = std::pow(0.052, 3);
  EXPECT_NEAR(*spread->rigidity_variation, (high - low) / std::sqrt(2) / ((high + low) / 2), 1e-12);
}

TEST(BendingLengthSpread, OfOneReadingIsUnknown) {
  const auto spread = bending_length_spread({0.05}, kOverhangAngle, 1);
  EXPECT_FALSE(spread->length_variation);
  EXPECT_FALSE(spread->rigidity_variation);
}

// Before it yields, a plastic range is elasticity.
TEST(BendingLength, OfALawWithAPlasticRangeIsLonger) {
  ComponentLaw law = elastic(2e-6);
  law.addends = {{*find_addend_kind("plastic"), Eigen::Vector2d(2e-6, 1e4)}};
  const auto length = bending_length(law, 0.2), stiff = bending_length(elastic(4e-6), 0.2);
  ASSERT_TRUE(length && stiff);
  EXPECT_NEAR(length->length, stiff->length, 1e-6);
}

TEST(BendingLength, IsNoneForASheetThatNeverDips) {
  EXPECT_FALSE(bending_length(elastic(1e6), 0.2));
}

}  // namespace
}  // namespace pliant
