#include "pliant/mechanics/shape_difference.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

constexpr double kRounding = 1e-12;

/// A square of 1 m whose two triangles are folded about the diagonal.
Eigen::Matrix3Xd folded(double angle) {
  Eigen::Matrix3Xd at = regular_grid(1, 1, 2, 2).positions;
  const Eigen::AngleAxisd turn(angle, Eigen::Vector3d(1, 1, 0).normalized());
  at.col(2) = turn * at.col(2);  // the upper left corner; the diagonal runs through the origin
  return at;
}

TEST(ShapeDifference, OfAShiftIsItsLengthAndNoCurvature) {
  const TriangleMesh mesh = regular_grid(0.2, 0.1, 4, 3);
  const Eigen::Matrix3Xd shifted = mesh.positions.colwise() + Eigen::Vector3d(0.003, 0, 0.004);
  const ShapeDifference difference = ShapeComparison(mesh)(mesh.positions, shifted);
  EXPECT_NEAR(difference.distance, 0.005, kRounding);
  EXPECT_NEAR(difference.largest_distance, 0.005, kRounding);
  EXPECT_NEAR(difference.curvature, 0, kRounding);
}

TEST(ShapeDifference, WeighsPointsByTheirRestArea) {
  const TriangleMesh mesh = regular_grid(1, 1, 2, 2);
  Eigen::Matrix3Xd moved = mesh.positions;
  moved(2, 2) += 0.1;  // a corner with a sixth of the area
  const ShapeDifference difference = ShapeComparison(mesh)(mesh.positions, moved);
  EXPECT_NEAR(difference.distance, 0.1 / std::sqrt(6), kRounding);
  EXPECT_NEAR(difference.largest_distance, 0.1, kRounding);
}

TEST(ShapeDifference, OfAFoldIsItsAngleOverTheHeightOfItsTriangles) {
  const ShapeComparison compare(regular_grid(1, 1, 2, 2));
  const double height = std::sqrt(0.5);
  EXPECT_NEAR(compare(folded(0), folded(0.3)).curvature, 0.3 / height, kRounding);
  EXPECT_NEAR(compare(folded(-0.2), folded(0.3)).curvature, 0.5 / height, kRounding);
  // Folded over from both sides, the triangles lie almost upon each other.
  const double half = std::numbers::pi;
  EXPECT_NEAR(compare(folded(half - 0.1), folded(0.1 - half)).curvature, 0.2 / height, kRounding);
}

}  // namespace
}  // namespace pliant
