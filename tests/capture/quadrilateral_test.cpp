#include "pliant/capture/quadrilateral.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr int kStep = 10, kMargin = 11;

Quadrilateral seen_askew() {
  Quadrilateral corners;
  corners << 103.4, 388.1, 402.7, 90.2, 95.8, 88.3, 371.5, 402.6;
  return corners;
}

Eigen::Vector2d corner(int k) { return seen_askew().col(k % 4); }

/// From the line through a corner and the next.
double distance(const Eigen::Vector2d& place, int side) {
  const Eigen::Vector2d along = (corner(side + 1) - corner(side)).normalized();
  const Eigen::Vector2d way = place - corner(side);
  return std::abs(along.x() * way.y() - along.y() * way.x());
}

TEST(Quadrilateral, PlacesReachAllOfItsSides) {
  const auto places = places_within(seen_askew(), kStep, kMargin);
  for (int side = 0; side < 4; ++side) {
    int beside = 0;
    for (const Eigen::Vector2d& place : places) {
      EXPECT_TRUE(is_within(seen_askew(), place, kMargin - 1));
      EXPECT_EQ(place, place.array().round().matrix());
      beside += distance(place, side) < kMargin + 1;
    }
    EXPECT_GT(beside, 25) << side;
  }
}

TEST(Quadrilateral, PlacesAreNoFurtherApartThanTheirStep) {
  const auto places = places_within(seen_askew(), kStep, kMargin);
  for (const Eigen::Vector2d& place : places) {
    double nearest = INFINITY;
    for (const Eigen::Vector2d& other : places) {
      if (other != place) nearest = std::min(nearest, (other - place).norm());
    }
    EXPECT_LE(nearest, kStep + 1);
    EXPECT_GE(nearest, kStep - 3);
  }
}

TEST(Quadrilateral, WithoutRoomHasNoPlaces) {
  Quadrilateral small;
  small << 0, 15, 15, 0, 0, 0, 15, 15;
  EXPECT_TRUE(places_within(small, kStep, kMargin).empty());
}

// The other way round, too.
TEST(Quadrilateral, MayTurnEitherWay) {
  const Quadrilateral turned = seen_askew().rowwise().reverse();
  const auto places = places_within(turned, kStep, kMargin);
  EXPECT_EQ(places.size(), places_within(seen_askew(), kStep, kMargin).size());
}

}  // namespace
}  // namespace pliant
