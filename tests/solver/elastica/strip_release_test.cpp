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

/// Points of the strip, equally far apart along it.
Points released_from(double radius, const PublishedBending& fabric, int elements, double accuracy) {
  const Elastica strip(kLength, elements);
  StripHistory history = strip.rolled(fabric.law(), 1 / radius);
  const auto shape = released(strip, fabric.law(), fabric.weight(), {}, false, history, accuracy);
  EXPECT_TRUE(shape) << fabric.name << " " << radius;
  const StripProfile profile = strip.profile({}, *shape);
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
