#include "pliant/geometry/convex_hull.h"

#include <cmath>

#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

Eigen::Matrix2Xd points(std::initializer_list<Eigen::Vector2d> list) {
  Eigen::Matrix2Xd matrix(2, list.size());
  Eigen::Index i = 0;
  for (const Eigen::Vector2d& point : list) matrix.col(i++) = point;
  return matrix;
}

TEST(ConvexHull, OfASquareGridIsItsCorners) {
  Eigen::Matrix2Xd grid(2, 25);
  for (int i = 0; i < 25; ++i) grid.col(i) << i % 5, i / 5;
  EXPECT_EQ(convex_hull(grid), points({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
}

TEST(ConvexHull, OfALineIsItsEndsAndOfAPointThePoint) {
  EXPECT_EQ(convex_hull(points({{1, 1}, {0, 0}, {3, 3}, {2, 2}})), points({{0, 0}, {3, 3}}));
  EXPECT_EQ(convex_hull(points({{1, 2}, {1, 2}})), points({{1, 2}}));
}

TEST(ConvexHull, HoldsEveryPointAndTurnsLeft) {
  RandomStream random(5);
  Eigen::Matrix2Xd cloud(2, 200);
  for (double& number : cloud.reshaped()) number = random.normal();
  const Eigen::Matrix2Xd hull = convex_hull(cloud);
  for (const auto& point : cloud.colwise()) EXPECT_LT(distance_from_convex(hull, point), 1e-14);
  double area = 0;
  for (Eigen::Index i = 0; i < hull.cols(); ++i) {
    const Eigen::Vector2d a = hull.col(i), b = hull.col((i + 1) % hull.cols());
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  EXPECT_GT(area, 0);
}

TEST(DistanceFromConvex, IsZeroInsideAndThatOfTheNearestSideOutside) {
  const Eigen::Matrix2Xd square = points({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(distance_from_convex(square, {0.2, 0.9}), 0);
  EXPECT_EQ(distance_from_convex(square, {1, 0.5}), 0);
  EXPECT_DOUBLE_EQ(distance_from_convex(square, {0.5, -2}), 2);
  EXPECT_DOUBLE_EQ(distance_from_convex(square, {4, 5}), 5);
}

TEST(DistanceFromConvex, KnowsSegmentsAndPoints) {
  EXPECT_DOUBLE_EQ(distance_from_convex(points({{0, 0}, {2, 0}}), {1, 3}), 3);
  EXPECT_DOUBLE_EQ(distance_from_convex(points({{0, 0}, {2, 0}}), {-3, 4}), 5);
  EXPECT_DOUBLE_EQ(distance_from_convex(points({{1, 1}}), {4, 5}), 5);
}

}  // namespace
}  // namespace pliant
