#include "pliant/geometry/tube.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "pliant/geometry/grid_pattern.h"

namespace pliant {
namespace {

constexpr double kAround = 0.25, kLong = 0.2;  // m

TEST(Tube, IsARectangleAtRest) {
  const TriangleMesh mesh = tube(kAround, kLong, 8, 5);
  EXPECT_EQ(mesh.vertex_count(), 8 * 5);
  EXPECT_EQ(mesh.triangle_count(), 2 * 8 * 4);
  EXPECT_NEAR(rest_area(mesh), kAround * kLong, 1e-15);
  EXPECT_EQ(mesh.rest_corners.row(0).maxCoeff(), kAround);
}

TEST(Tube, IsClosedAndOfOnePattern) {
  for (const Diagonals diagonals :
       {Diagonals::alternating, Diagonals::rising, Diagonals::falling}) {
    const TriangleMesh mesh = tube(kAround, kLong, 8, 5, diagonals);
    const std::vector<Hinge> hinges = find_hinges(mesh);
    // Three edges a square, and those of the upper rim; both rims are borders.
    EXPECT_EQ(hinges.size(), 8u * (3 * 4 + 1) - 2 * 8);
    const auto pattern = grid_pattern(mesh, hinges);
    ASSERT_TRUE(pattern);
    EXPECT_EQ(pattern->diagonals, diagonals);
  }
}

TEST(Tube, StretchesNoEdgeAroundOrAlong) {
  const TriangleMesh mesh = tube(kAround, kLong, 8, 5);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const Eigen::Vector2d rest = mesh.rest_triangle(t).col(next) - mesh.rest_triangle(t).col(k);
      const Eigen::Vector3d edge =
          mesh.positions.col(mesh.triangles(next, t)) - mesh.positions.col(mesh.triangles(k, t));
      EXPECT_NEAR(edge.norm(), rest.norm(), 1e-15);
    }
  }
}

TEST(Tube, StandsOnItsLowerRimWithItsFrontOutside) {
  const TriangleMesh mesh = tube(kAround, kLong, 8, 5);
  EXPECT_EQ(mesh.positions.row(2).minCoeff(), 0);
  EXPECT_EQ(mesh.positions.row(2).maxCoeff(), kLong);
  for (const auto& triangle : mesh.triangles.colwise()) {
    const Eigen::Vector3d a = mesh.positions.col(triangle(0)), b = mesh.positions.col(triangle(1)),
                          c = mesh.positions.col(triangle(2));
    const Eigen::Vector3d outwards((a + b + c).x(), (a + b + c).y(), 0);
    EXPECT_GT((b - a).cross(c - a).dot(outwards), 0);
  }
}

}  // namespace
}  // namespace pliant
