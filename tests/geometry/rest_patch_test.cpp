#include "pliant/geometry/rest_patch.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

namespace pliant {
namespace {

TEST(RestPatch, OfASmallSheetIsTheSheet) {
  const TriangleMesh mesh = regular_grid(0.3, 0.2, 7, 5);
  const RestPatch patch = rest_patch(mesh, 1000);
  EXPECT_EQ(patch.mesh.vertex_count(), mesh.vertex_count());
  EXPECT_EQ(patch.mesh.triangle_count(), mesh.triangle_count());
  EXPECT_NEAR(rest_area(patch.mesh), 0.06, 1e-15);
}

TEST(RestPatch, CountsDepthsInEdgesFromTheRim) {
  // Unit squares: the rim of a grid is as many edges away as coordinates say, because diagonals
  // lead along the rim and not nearer to it.
  const RestPatch patch = rest_patch(regular_grid(8, 6, 9, 7), 1000);
  for (int i = 0; i < patch.mesh.vertex_count(); ++i) {
    const Eigen::Vector3d x = patch.mesh.positions.col(i);
    EXPECT_EQ(patch.depths[i], std::min({x.x(), x.y(), 8 - x.x(), 6 - x.y()}));
  }
}

TEST(RestPatch, OfALargeSheetIsAConnectedPieceOfItsMiddle) {
  const RestPatch patch = rest_patch(regular_grid(40, 40, 41, 41), 200);
  EXPECT_EQ(patch.mesh.triangle_count(), 200);
  const Eigen::Vector3d middle = patch.mesh.positions.rowwise().mean();
  EXPECT_LT((middle - Eigen::Vector3d(20, 20, 0)).norm(), 1);
  EXPECT_GE(*std::max_element(patch.depths.begin(), patch.depths.end()), 4);
}

TEST(RestPatch, StopsAtSeams) {
  // Eight squares by four; the last two columns of squares lie elsewhere in the rest plane.
  TriangleMesh mesh = regular_grid(8, 4, 9, 5);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    if (mesh.rest_triangle(t).row(0).mean() < 6) continue;
    mesh.rest_corners.middleCols<3>(3 * t).array() += 100;
  }
  const RestPatch patch = rest_patch(mesh, 1000);
  EXPECT_EQ(patch.mesh.triangle_count(), 2 * 6 * 4);
  EXPECT_NEAR(patch.mesh.positions.maxCoeff(), 6, 1e-15);
}

}  // namespace
}  // namespace pliant
