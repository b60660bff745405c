#include "pliant/geometry/hinges.h"

#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

TEST(Hinges, AreTheInteriorEdges) {
  // Euler: edges = vertices + triangles - 1 for a disc; the outline has 2 (nu + nv) - 4 of them.
  const TriangleMesh mesh = regular_grid(0.3, 0.2, 4, 3);
  EXPECT_EQ(find_hinges(mesh).size(), 12 + 12 - 1 - 10);
}

TEST(Hinges, JoinTheTwoTrianglesOfTheirEdge) {
  const TriangleMesh mesh = regular_grid(0.3, 0.2, 4, 3, Diagonals::rising);
  for (const Hinge& hinge : find_hinges(mesh)) {
    for (int side = 0; side < 2; ++side) {
      const Eigen::Vector3i corners = mesh.triangles.col(hinge.triangles[side]);
      const int opposite = hinge.vertices[2 + side];
      EXPECT_TRUE((corners.array() == hinge.vertices[0]).any());
      EXPECT_TRUE((corners.array() == hinge.vertices[1]).any());
      EXPECT_TRUE((corners.array() == opposite).any());
    }
    EXPECT_NE(hinge.vertices[2], hinge.vertices[3]);
  }
}

TEST(Hinges, KnowTheirRestEdgeHeightAndArea) {
  // One square of side 0.1: its diagonal has triangles of height 0.1 / sqrt(2) over it.
  const std::vector<Hinge> hinges = find_hinges(regular_grid(0.1, 0.1, 2, 2));
  ASSERT_EQ(hinges.size(), 1u);
  const double diagonal = 0.1 * std::sqrt(2.0);
  EXPECT_NEAR(hinges[0].rest_edge.norm(), diagonal, 1e-16);
  EXPECT_NEAR(hinges[0].height, 0.005 * 2 / diagonal, 1e-16);
  EXPECT_NEAR(hinges[0].area, diagonal * hinges[0].height / 3, 1e-17);  // [T] 5.2.1
}

TEST(Hinges, OfSewnPanelsCrossTheSeam) {
  // Two squares that share an edge in space but lie apart in the rest plane.
  TriangleMesh mesh = regular_grid(0.2, 0.1, 3, 2);
  for (int t = 2; t < 4; ++t) {
    for (int k = 0; k < 3; ++k) mesh.rest_corners.col(3 * t + k) += Eigen::Vector2d(5, 5);
  }
  EXPECT_EQ(find_hinges(mesh).size(), 3u);
}

TEST(Hinges, RefuseAnEdgeWithThreeTriangles) {
  Eigen::Matrix2Xd vertices(2, 5);
  vertices << 0, 1, 0, 1, 2, 0, 0, 1, 1, 2;
  Eigen::Matrix3Xi triangles(3, 2);
  triangles << 0, 0, 1, 1, 2, 3;  // both run from 0 to 1
  EXPECT_THROW(find_hinges(flat_mesh(vertices, triangles)), AssertionError);
}

}  // namespace
}  // namespace pliant
