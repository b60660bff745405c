#include "pliant/geometry/topology.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/geometry/hinges.h"
#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

using testing::ElementsAre;

TEST(SameTriangles, ComparesMeshesOfAnySize) {
  const TriangleMesh mesh = regular_grid(1, 1, 3, 3);
  EXPECT_TRUE(same_triangles(mesh.triangles, regular_grid(2, 1, 3, 3).triangles));
  EXPECT_FALSE(same_triangles(mesh.triangles, regular_grid(1, 1, 2, 3).triangles));
  EXPECT_FALSE(same_triangles(regular_grid(1, 1, 2, 3).triangles, mesh.triangles));
  Eigen::Matrix3Xi turned = mesh.triangles;
  turned.col(0).reverseInPlace();
  EXPECT_FALSE(same_triangles(mesh.triangles, turned));
}

TEST(Edges, AreAsManyAsEulerSays) {
  const TriangleMesh mesh = regular_grid(0.3, 0.2, 5, 4);
  const std::vector<MeshEdge> edges = find_edges(mesh.triangles);
  EXPECT_EQ(edges.size(), mesh.vertex_count() + mesh.triangle_count() - 1u);  // a disc
  const auto boundary = std::count_if(edges.begin(), edges.end(),
                                      [](const MeshEdge& edge) { return edge.is_boundary(); });
  EXPECT_EQ(boundary, 2 * (4 + 3));
  EXPECT_EQ(edges.size() - boundary, find_hinges(mesh).size());
}

TEST(Edges, AreSortedAndKnowTheirTriangles) {
  const TriangleMesh mesh = regular_grid(1, 1, 2, 2);  // triangles 0 1 3 and 0 3 2
  std::vector<std::array<int, 2>> vertices;
  for (const MeshEdge& edge : find_edges(mesh.triangles)) {
    vertices.push_back(edge.vertices);
    if (edge.vertices == std::array{0, 3}) {
      EXPECT_THAT(edge.triangles, ElementsAre(0, 1));
    }
    if (edge.vertices == std::array{2, 3}) {
      EXPECT_THAT(edge.triangles, ElementsAre(1, -1));
    }
  }
  EXPECT_THAT(vertices, ElementsAre(std::array{0, 1}, std::array{0, 2}, std::array{0, 3},
                                    std::array{1, 3}, std::array{2, 3}));
}

TEST(Edges, HaveAtMostTwoTriangles) {
  Eigen::Matrix3Xi triangles(3, 3);
  triangles << 0, 1, 0, 1, 0, 1, 2, 3, 4;
  EXPECT_THROW(find_edges(triangles), AssertionError);
  EXPECT_EQ(sides_by_edge(triangles).size(), 9u);
}

TEST(VertexNeighbours, AreTheRingOfAVertex) {
  const TriangleMesh mesh = regular_grid(1, 1, 3, 3);  // diagonals alternate: 0-4, 2-4, 6-4, 8-4
  const VertexNeighbours neighbours(mesh.vertex_count(), mesh.triangles);
  EXPECT_EQ(neighbours.vertex_count(), 9);
  EXPECT_THAT(neighbours[4], ElementsAre(0, 1, 2, 3, 5, 6, 7, 8));
  EXPECT_THAT(neighbours[1], ElementsAre(0, 2, 4));
  EXPECT_THAT(neighbours[0], ElementsAre(1, 3, 4));
}

TEST(VertexNeighbours, OfAVertexWithoutTrianglesAreNone) {
  Eigen::Matrix3Xi triangles(3, 1);
  triangles << 0, 1, 3;
  const VertexNeighbours neighbours(4, triangles);
  EXPECT_TRUE(neighbours[2].empty());
  EXPECT_THAT(neighbours[3], ElementsAre(0, 1));
  EXPECT_THROW(VertexNeighbours(3, triangles), AssertionError);
}

}  // namespace
}  // namespace pliant
