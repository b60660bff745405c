// Strips that are let go from a cylinder: what friction keeps, and how finely the path is followed.

#include "pliant/solver/elastica/strip_release.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/published_bending.h"

namespace pliant {
namespace {

using test::PublishedBending;

constexpr double kLength = 0.1;  // m

using Points = std::vector<Eigen::Vector2d>;

StripShape shape_from(double radius, const PublishedBending& fabric, const Elastica& strip,
                      double accuracy) {
  StripHistory history = strip.rolled(fabric.law(), 1 / radius);
  const auto shape = released(strip, fabric.law(), fabric.weight(), {}, true, history, accuracy);
  EXPECT_TRUE(shape) << fabric.name << " " << radius;
  return *shape;
}

/// Points of the strip, equally far apart along it.
Points released_from(double radius, const PublishedBending& fabric, int elements, double accuracy) {
  const Elastica strip(kLength, elements);
  const StripShape shape = shape_from(radius, fabric, strip, accuracy);
  const StripProfile profile = strip.profile({}, shape);
  Points points;
  for (int i = 0; i <= 50; ++i) points.push_back(profile.at(kLength * i / 50).position);
  return points;
}

double distance(const Points& a, const Points& b) {
  double largest = 0;
  for (size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

// Two of these strips swing down and bend back and forth; of one the curl tips over at the end.
TEST(StripRelease, EndsWhereAFinerOneDoes) {
  const auto fabrics = test::published_bending();
  for (const double radius : {0.005, 0.01, 0.016, 0.0315}) {
    for (const PublishedBending& fabric : {fabrics[0], fabrics[1]}) {
      const Points coarse = released_from(radius, fabric, 12, kReleaseAccuracy);
      const Points fine = released_from(radius, fabric, 12, kReleaseAccuracy / 100);
      EXPECT_LT(distance(coarse, fine), 1e-5) << fabric.name << " " << radius;
    }
  }
}

TEST(StripRelease, NeedsFewElements) {
  const PublishedBending doublecloth = test::published_bending()[1];
  for (const double radius : {0.004, 0.01, 0.023, 0.05}) {
    const Points few = released_from(radius, doublecloth, 6, kReleaseAccuracy);
    const Points many = released_from(radius, doublecloth, 24, kReleaseAccuracy / 100);
    EXPECT_LT(distance(few, many), 3e-5) << radius;  // a third of what a photograph tells
  }
}

// Paper jumps off the wider cylinders: a curl is left behind a front, which lies between the points
// of the line.
class JumpedStrip : public ::testing::TestWithParam<double> {
 protected:
  const PublishedBending paper_ = test::published_bending()[2];
};

TEST_P(JumpedStrip, EndsWhereAFinerOneDoes) {
  const Points few = released_from(GetParam(), paper_, 8, kReleaseAccuracy);
  const Points many = released_from(GetParam(), paper_, 64, kReleaseAccuracy / 100);
  // Half of what a photograph tells. A front at the next point is up to 0.8 mm off.
  EXPECT_LT(distance(few, many), 6e-5);
}

TEST_P(JumpedStrip, HasItsFrontWhereTheCurlJustHolds) {
  // 6 x 64 points, half a millimetre apart at most.
  const Elastica strip(kLength, 64);
  const StripShape shape = shape_from(GetParam(), paper_, strip, kReleaseAccuracy);
  double largest_jump = 0, moment = 0;
  for (Eigen::Index i = 0; i + 1 < shape.curvature.size(); ++i) {
    const double jump = shape.curvature(i + 1) - shape.curvature(i);
    if (jump < largest_jump) continue;
    largest_jump = jump;
    // Of what hangs beyond.
    const StripProfile profile = strip.profile({}, shape);
    const double place = strip.line().places()(i);
    constexpr int kPieces = 1000;
    moment = 0;
    for (int k = 0; k < kPieces; ++k) {
      const double piece = (kLength - place) / kPieces;
      moment -=
          paper_.weight() * piece *
          (profile.at(place + (k + 0.5) * piece).position.x() - profile.at(place).position.x());
    }
  }
  // The least moment of a point on its way back from the cylinder.
  const ComponentLaw law = paper_.law();
  const double rolled = 3 / GetParam();
  const FrictionState from{rolled, law.friction_stress(rolled, {}).stress};
  double least = std::numeric_limits<double>::infinity();
  for (int i = 1; i < 1000; ++i) {
    const double strain = rolled * i / 1000;
    least = std::min(least, law.elastic_stress(strain) + law.friction_stress(strain, from).stress);
  }
  EXPECT_GT(largest_jump, 5);  // 1/m: there is a front
  // Half a millimetre moves the moment by two per cent.
  EXPECT_NEAR(moment, least, 0.02 * std::abs(least));
}

TEST_P(JumpedStrip, HasTheDerivativesOfItsFront) {
  constexpr double kStep = 0.004;  // several points of the finer line snap within it
  const Elastica strip(kLength, 8);
  const StripShape shape = shape_from(GetParam(), paper_, strip, kReleaseAccuracy);
  const Eigen::MatrixXd by_parameter = strip.profile({}, shape).position_by_parameter(kLength);
  const auto tip = [&](double change) {
    PublishedBending other = paper_;
    other.k1 *= 1 + change;
    return released_from(GetParam(), other, 64, kReleaseAccuracy / 100).back();
  };
  const Eigen::Vector2d difference = (tip(kStep) - tip(-kStep)) / (2 * kStep);
  // A front that stays misses 0.7 to 1.1 of it; that the curl gives way along a chord, a tenth.
  EXPECT_LT((by_parameter.col(0) * paper_.k1 - difference).norm(), 0.12 * difference.norm());
}

INSTANTIATE_TEST_SUITE_P(Of, JumpedStrip, ::testing::Values(0.0275, 0.0315, 0.05),
                         [](const auto& radius) {
                           return std::to_string(static_cast<int>(1e4 * radius.param + 0.5)) +
                                  "TenthsOfAMillimetre";
                         });

TEST(StripRelease, LeavesTheHistoryAloneWhereItFails) {
  PublishedBending felt = test::published_bending()[0];
  const Elastica strip(kLength);
  StripHistory history = strip.rolled(felt.law(), 100);
  const Eigen::VectorXd before = history.curvature;
  const double no_number = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(released(strip, felt.law(), no_number, {}, false, history));
  EXPECT_EQ(history.curvature, before);
}

}  // namespace
}  // namespace pliant
