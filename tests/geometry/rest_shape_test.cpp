#include "pliant/geometry/rest_shape.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

using testing::Each;
using testing::ElementsAre;

/// A grid moved in space; its own rest shape stays where it was.
TriangleMesh turned(const Eigen::AngleAxisd& turn) {
  TriangleMesh mesh = regular_grid(0.4, 0.3, 5, 4);
  mesh.positions = turn.toRotationMatrix() * mesh.positions;
  mesh.positions.colwise() += Eigen::Vector3d(1, 2, 3);
  return mesh;
}

/// A mesh whose rest coordinates are those of a layout.
TriangleMesh with(TriangleMesh mesh, const ShapeLayout& layout) {
  mesh.rest_corners = layout.rest_corners;
  return mesh;
}

/// Largest difference of a triangle's sides at rest and in space.
double largest_strain(const TriangleMesh& mesh) {
  double largest = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const double rest = (mesh.rest_triangle(t).col(next) - mesh.rest_triangle(t).col(k)).norm();
      const double space =
          (mesh.positions.col(mesh.triangles(next, t)) - mesh.positions.col(mesh.triangles(k, t)))
              .norm();
      largest = std::max(largest, std::abs(rest - space));
    }
  }
  return largest;
}

TEST(ShapeLayout, OfAMeshInThePlaneOfXAndYIsItself) {
  const TriangleMesh mesh = regular_grid(0.4, 0.3, 5, 4);
  const ShapeLayout layout = lay_out_shape(mesh.positions, mesh.triangles);
  EXPECT_TRUE(layout.flat);
  EXPECT_TRUE(layout.rest_corners == mesh.rest_corners);  // to the bit
}

TEST(ShapeLayout, OfAHangingSheetHasWeftAlongXAndWarpAlongZ) {
  const TriangleMesh mesh =
      turned(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()));
  const ShapeLayout layout = lay_out_shape(mesh.positions, mesh.triangles);
  EXPECT_TRUE(layout.flat);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = mesh.positions.col(mesh.triangles(k, t));
      EXPECT_NEAR(layout.rest_corners(0, 3 * t + k), p.x(), 1e-14);  // rounding
      EXPECT_NEAR(layout.rest_corners(1, 3 * t + k), p.z(), 1e-14);
    }
  }
}

TEST(ShapeLayout, OfASheetAtARightAngleToXHasWeftAlongY) {
  const TriangleMesh mesh =
      turned(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()));
  const ShapeLayout layout = lay_out_shape(mesh.positions, mesh.triangles);
  EXPECT_TRUE(layout.flat);
  const Eigen::Vector3d p = mesh.positions.col(mesh.triangles(0, 0));
  EXPECT_NEAR(layout.rest_corners(0, 0), p.y(), 1e-14);
  EXPECT_NEAR(layout.rest_corners(1, 0), p.z(), 1e-14);
}

TEST(ShapeLayout, OfAFlatSheetIsOnePiece) {
  const TriangleMesh mesh = turned(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const TriangleMesh laid_out = with(mesh, lay_out_shape(mesh.positions, mesh.triangles));
  EXPECT_LT(largest_strain(laid_out), 1e-14);
  for (const AreaPair& area : compare_areas(laid_out, find_panels(laid_out))) {
    EXPECT_NEAR(area.rest, area.space, 1e-14);
  }
}

TEST(ShapeLayout, OfACylinderHasTheSizeOfEveryTriangle) {
  TriangleMesh mesh = regular_grid(0.4, 0.3, 9, 4);
  for (auto p : mesh.positions.colwise()) {
    p = Eigen::Vector3d(0.1 * std::sin(p.x() / 0.1), p.y(), 0.1 * std::cos(p.x() / 0.1));
  }
  const ShapeLayout layout = lay_out_shape(mesh.positions, mesh.triangles);
  EXPECT_FALSE(layout.flat);
  mesh = with(mesh, layout);
  EXPECT_LT(largest_strain(mesh), 1e-14);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    EXPECT_GT(rest_area(mesh, t), 0);
    // Sides along the cylinder's axis, y, are warp.
    for (int k = 0; k < 3; ++k) {
      const int from = mesh.triangles(k, t), to = mesh.triangles((k + 1) % 3, t);
      const Eigen::Vector3d side = mesh.positions.col(to) - mesh.positions.col(from);
      if (side.cwiseAbs().x() + side.cwiseAbs().z() > 1e-12) continue;
      const Eigen::Vector2d rest =
          mesh.rest_triangle(t).col((k + 1) % 3) - mesh.rest_triangle(t).col(k);
      EXPECT_NEAR(rest.x(), 0, 1e-14);
    }
  }
}

TEST(Panels, AreJoinedByEdgesThatAreOneAtRest) {
  TriangleMesh mesh = regular_grid(0.4, 0.1, 5, 2);
  EXPECT_THAT(find_panels(mesh), Each(0));
  mesh.rest_corners.rightCols(3 * 4).colwise() += Eigen::Vector2d(1, 0);  // cut in the middle
  EXPECT_THAT(find_panels(mesh), ElementsAre(0, 0, 0, 0, 1, 1, 1, 1));
}

TEST(Areas, AreComparedByPanel) {
  TriangleMesh mesh = regular_grid(0.4, 0.1, 5, 2);
  mesh.rest_corners.rightCols(3 * 4) *= 2;
  const std::vector<AreaPair> areas = compare_areas(mesh, find_panels(mesh));
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_NEAR(areas[0].mismatch(), 1, 1e-12);
  EXPECT_NEAR(areas[1].mismatch(), 4, 1e-12);
  EXPECT_NEAR(compare_areas(mesh).rest, 0.02 + 0.08, 1e-15);
  EXPECT_NEAR(compare_areas(mesh).space, 0.04, 1e-15);
  EXPECT_TRUE(std::isinf(AreaPair{}.mismatch()));
}

}  // namespace
}  // namespace pliant
