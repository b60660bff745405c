#include "pliant/geometry/regular_grid.h"

#include <gtest/gtest.h>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

const Diagonals kAllDiagonals[] = {Diagonals::alternating, Diagonals::rising, Diagonals::falling};

TEST(RegularGrid, CoversItsRectangleWithEqualCounterClockwiseTriangles) {
  for (const Diagonals diagonals : kAllDiagonals) {
    const TriangleMesh mesh = regular_grid(0.3, 0.2, 4, 3, diagonals);
    EXPECT_EQ(mesh.vertex_count(), 12);
    EXPECT_EQ(mesh.triangle_count(), 12);
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      EXPECT_NEAR(rest_area(mesh, t), 0.005, 1e-15);  // rounding
    }
    EXPECT_NEAR(rest_area(mesh), 0.06, 1e-15);
  }
}

TEST(RegularGrid, NumbersItsVerticesRowByRow) {
  const TriangleMesh mesh = regular_grid(0.3, 0.2, 4, 3);
  EXPECT_TRUE(mesh.positions.col(0).isZero());
  EXPECT_TRUE(mesh.positions.col(3).isApprox(Eigen::Vector3d(0.3, 0, 0)));
  EXPECT_TRUE(mesh.positions.col(11).isApprox(Eigen::Vector3d(0.3, 0.2, 0)));
}

TEST(GridOfLines, HasItsVerticesWhereLinesCross) {
  const TriangleMesh mesh = grid_of_lines({-0.1, 0, 0.3}, {0.2, 0.25});
  ASSERT_EQ(mesh.vertex_count(), 6);
  EXPECT_TRUE(mesh.positions.col(5).isApprox(Eigen::Vector3d(0.3, 0.25, 0)));
  EXPECT_NEAR(rest_area(mesh), 0.4 * 0.05, 1e-15);
  EXPECT_THROW(grid_of_lines({0, 0.1, 0.1}, {0, 1}), AssertionError);
  EXPECT_THROW(grid_of_lines({0}, {0, 1}), AssertionError);
}

TEST(RegularGrid, IsItsOwnRestShape) {
  const TriangleMesh mesh = regular_grid(0.3, 0.2, 4, 3);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d corner = mesh.rest_triangle(t).col(k);
      EXPECT_EQ(mesh.positions.col(mesh.triangles(k, t)).head<2>(), corner);
    }
  }
}

// The number of triangles at a vertex tells the pattern: 8 and 4 in turn, or 6 everywhere inside.
TEST(RegularGrid, CutsItsSquaresAsAsked) {
  const auto valence = [](Diagonals diagonals, int vertex) {
    return (regular_grid(1, 1, 5, 5, diagonals).triangles.array() == vertex).count();
  };
  EXPECT_EQ(valence(Diagonals::alternating, 12), 8);
  EXPECT_EQ(valence(Diagonals::alternating, 13), 4);
  for (const int vertex : {12, 13}) {
    EXPECT_EQ(valence(Diagonals::rising, vertex), 6);
    EXPECT_EQ(valence(Diagonals::falling, vertex), 6);
  }
}

TEST(RegularGrid, RefusesARectangleWithoutSquares) {
  EXPECT_THROW(regular_grid(1, 1, 1, 5), AssertionError);
  EXPECT_THROW(regular_grid(0, 1, 2, 5), AssertionError);
}

}  // namespace
}  // namespace pliant
