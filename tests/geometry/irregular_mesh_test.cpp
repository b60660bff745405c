#include "pliant/geometry/irregular_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/geometry/mesh_quality.h"
#include "pliant/geometry/topology.h"

namespace pliant {
namespace {

struct Rectangle {
  double width, height, edge_length;
};

class IrregularRectangle : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  }
};

TEST_F(IrregularRectangle, IsAGoodMeshOfTheWholeRectangle) {
  for (const auto& [width, height, edge] :
       {Rectangle{0.1, 0.1, 0.004}, {0.31, 0.07, 0.004}, {0.1, 0.1, 0.013}, {3, 1, 0.1}}) {
    const TriangleMesh mesh = irregular_rectangle(width, height, edge);
    EXPECT_TRUE(find_mesh_problems(mesh).empty());
    EXPECT_NEAR(rest_area(mesh), width * height, 1e-12 * width * height);  // rounding
    const MeshQuality quality = mesh_quality(mesh);
    EXPECT_GT(quality.smallest_angle, 25 * std::numbers::pi / 180);
    EXPECT_LT(quality.longest_edge, 1.7 * edge);
    EXPECT_GT(quality.shortest_edge, 0.5 * edge);
    EXPECT_NEAR(quality.mean_edge, edge, 0.06 * edge);  // as its header promises
  }
}

TEST_F(IrregularRectangle, HasAnOutlineOfEqualEdgesExactlyOnItsSides) {
  const double width = 0.31, height = 0.07;
  const TriangleMesh mesh = irregular_rectangle(width, height, 0.01);
  int boundary_edges = 0;
  std::set<int> corners;
  for (const MeshEdge& edge : find_edges(mesh.triangles)) {
    if (!edge.is_boundary()) continue;
    ++boundary_edges;
    const auto [a, b] = edge.vertices;
    EXPECT_NEAR((mesh.positions.col(a) - mesh.positions.col(b)).norm(), 0.01, 1e-15);
    for (const int vertex : {a, b}) {
      const double x = mesh.positions(0, vertex), y = mesh.positions(1, vertex);
      const bool left_or_right = x == 0 || x == width, low_or_high = y == 0 || y == height;
      EXPECT_TRUE(left_or_right || low_or_high);
      if (left_or_right && low_or_high) corners.insert(vertex);
    }
  }
  EXPECT_EQ(boundary_edges, 2 * (31 + 7));
  EXPECT_EQ(corners.size(), 4u);
}

// A sheet of it must be as stiff in one direction as in another.
TEST_F(IrregularRectangle, HasEdgesOfAllDirectionsAlike) {
  const TriangleMesh mesh = irregular_rectangle(0.2, 0.2, 0.004);
  std::array<double, 6> parts{};
  double count = 0;
  for (const MeshEdge& edge : find_edges(mesh.triangles)) {
    if (edge.is_boundary()) continue;
    const Eigen::Vector3d d =
        mesh.positions.col(edge.vertices[1]) - mesh.positions.col(edge.vertices[0]);
    const double turn = std::atan2(d.y(), d.x()) / std::numbers::pi + 1;  // in [0, 2]
    ++parts[static_cast<std::size_t>(turn * 6) % 6];
    ++count;
  }
  // About 7000 edges: 1200 a part, three standard deviations of 32 each are 8 %; the rows along
  // the outline favour its directions a little.
  for (const double part : parts) EXPECT_NEAR(part / count, 1.0 / 6, 0.15 / 6);
}

// Whether the edges along a line cover all of it, without a gap.
bool is_line_of_edges(const TriangleMesh& mesh, const Eigen::Vector2d& from,
                      const Eigen::Vector2d& to) {
  const Eigen::AlignedBox2d line(from.cwiseMin(to), from.cwiseMax(to));
  double covered = 0;
  for (const MeshEdge& edge : find_edges(mesh.triangles)) {
    const Eigen::Vector2d a = mesh.positions.col(edge.vertices[0]).head<2>();
    const Eigen::Vector2d b = mesh.positions.col(edge.vertices[1]).head<2>();
    if (line.contains(a) && line.contains(b)) covered += (b - a).norm();
  }
  return std::abs(covered - (to - from).norm()) < 1e-12;
}

TEST_F(IrregularRectangle, HasEdgesAlongTheSidesOfRegions) {
  const auto box = [](double u0, double v0, double u1, double v1) {
    return Eigen::AlignedBox2d(Eigen::Vector2d(u0, v0), Eigen::Vector2d(u1, v1));
  };
  // A bar along a side, one in a part of another, a corner, and one that touches nothing; their
  // sides are no multiples of an edge.
  const std::vector<Eigen::AlignedBox2d> regions{box(0, 0.02, 0.005, 0.08), box(0.095, 0, 0.1, 0.1),
                                                 box(0, 0.0937, 0.0063, 0.1),
                                                 box(0.03, 0.04, 0.06, 0.047)};
  const TriangleMesh mesh = irregular_rectangle(0.1, 0.1, 0.0025, regions);
  EXPECT_TRUE(find_mesh_problems(mesh).empty());
  EXPECT_NEAR(rest_area(mesh), 0.01, 1e-14);
  for (const Eigen::AlignedBox2d& region : regions) {
    const Eigen::Vector2d low = region.min(), high = region.max();
    EXPECT_TRUE(is_line_of_edges(mesh, low, {high.x(), low.y()}));
    EXPECT_TRUE(is_line_of_edges(mesh, {high.x(), low.y()}, high));
    EXPECT_TRUE(is_line_of_edges(mesh, {low.x(), high.y()}, high));
    EXPECT_TRUE(is_line_of_edges(mesh, low, {low.x(), high.y()}));
  }
  const MeshQuality quality = mesh_quality(mesh);
  EXPECT_GT(quality.smallest_angle, 25 * std::numbers::pi / 180);
  EXPECT_NEAR(quality.mean_edge, 0.0025, 0.06 * 0.0025);  // as its header promises
}

TEST_F(IrregularRectangle, IsTheSameForTheSameArguments) {
  const TriangleMesh first = irregular_rectangle(0.2, 0.1, 0.005);
  const TriangleMesh second = irregular_rectangle(0.2, 0.1, 0.005);
  EXPECT_TRUE(first.positions == second.positions);
  EXPECT_TRUE(first.triangles == second.triangles);
}

TEST_F(IrregularRectangle, NumbersNeighboursNearToEachOther) {
  const TriangleMesh mesh = irregular_rectangle(0.2, 0.1, 0.002);
  int widest = 0;
  for (const MeshEdge& edge : find_edges(mesh.triangles)) {
    widest = std::max(widest, edge.vertices[1] - edge.vertices[0]);
  }
  // A strip holds about 0.2 / 0.002 * 1.15 vertices; an edge leads at most to the second next.
  EXPECT_LT(widest, 3 * 115);
}

TEST_F(IrregularRectangle, MayBeAsCoarseAsTwoTriangles) {
  EXPECT_TRUE(find_mesh_problems(irregular_rectangle(1, 1, 5)).empty());
  EXPECT_THROW(irregular_rectangle(0, 1, 0.1), AssertionError);
  EXPECT_THROW(irregular_rectangle(1, 1, 0), AssertionError);
}

TEST(IrregularRectangleWithoutCgal, SaysWhatIsMissing) {
  if (has_irregular_meshes()) GTEST_SKIP() << "built with CGAL";
  EXPECT_THROW(irregular_rectangle(1, 1, 0.1), InputError);
}

using IrregularDisc = IrregularRectangle;

TEST_F(IrregularDisc, IsAGoodMeshOfTheWholeDisc) {
  for (const auto& [radius, inner, edge] :
       {std::tuple{0.15, 0.09, 0.006}, {0.12, 0.09, 0.01}, {1.0, 0.2, 0.05}}) {
    const TriangleMesh mesh = irregular_disc(radius, inner, edge);
    EXPECT_TRUE(find_mesh_problems(mesh).empty());
    const auto parts = static_cast<double>(std::lround(2 * std::numbers::pi * radius / edge));
    const double polygon = parts / 2 * radius * radius * std::sin(2 * std::numbers::pi / parts);
    EXPECT_NEAR(rest_area(mesh), polygon, 1e-9 * polygon);
    const MeshQuality quality = mesh_quality(mesh);
    EXPECT_GT(quality.smallest_angle, 25 * std::numbers::pi / 180);
    EXPECT_LT(quality.longest_edge, 1.7 * edge);
    EXPECT_GT(quality.shortest_edge, 0.5 * edge);
    EXPECT_NEAR(quality.mean_edge, edge, 0.06 * edge);  // as its header promises
  }
}

TEST_F(IrregularDisc, HasEdgesAlongItsCirclesThatNoneCrosses) {
  const double radius = 0.15, inner = 0.09, edge_length = 0.006;
  const TriangleMesh mesh = irregular_disc(radius, inner, edge_length);
  const auto distance = [&](int vertex) { return mesh.positions.col(vertex).norm(); };
  const double dip = edge_length * edge_length / (4 * inner);  // of a chord into its circle
  for (const MeshEdge& edge : find_edges(mesh.triangles)) {
    const auto [near, far] = std::minmax({distance(edge.vertices[0]), distance(edge.vertices[1])});
    if (edge.is_boundary()) {
      EXPECT_NEAR(near, radius, 1e-12);
      EXPECT_NEAR(far, radius, 1e-12);
    }
    EXPECT_FALSE(near < inner - dip && far > inner + 1e-12) << near << " to " << far;
  }
}

TEST_F(IrregularDisc, IsTheSameForTheSameArguments) {
  const TriangleMesh first = irregular_disc(0.15, 0.09, 0.01);
  const TriangleMesh second = irregular_disc(0.15, 0.09, 0.01);
  EXPECT_EQ(first.positions, second.positions);
  EXPECT_EQ(first.triangles, second.triangles);
}

}  // namespace
}  // namespace pliant
