#include "pliant/geometry/block_mesh.h"

#include <set>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "pliant/geometry/volume_quality.h"

namespace pliant {
namespace {

const Eigen::Vector3d kSize(1, 2, 3);

std::vector<VolumeMesh> blocks() {
  return {block_of_hexahedra(kSize, {2, 3, 4}), block_of_tetrahedra(kSize, {2, 3, 4})};
}

TEST(BlockMesh, FillsItsBlockWithGoodElements) {
  for (const VolumeMesh& mesh : blocks()) {
    EXPECT_TRUE(find_volume_problems(mesh).empty());
    EXPECT_EQ(mesh.node_count(), 3 * 4 * 5);
    EXPECT_NEAR(element_volumes(mesh).sum(), 6, 1e-13);
    EXPECT_NEAR(node_volumes(mesh).sum(), 6, 1e-13);
    const double cell = 6.0 / (2 * 3 * 4);
    const double each = mesh.hexahedron_count() > 0 ? cell : cell / 6;
    EXPECT_TRUE((element_volumes(mesh).array() - each).abs().maxCoeff() < 1e-14);
  }
}

TEST(BlockMesh, HasTheSurfaceOfABlockWithNormalsOutwards) {
  for (const VolumeMesh& mesh : blocks()) {
    const BoundarySurface surface = boundary_surface(mesh);
    EXPECT_EQ(surface.triangles.cols(), 2 * 2 * (2 * 3 + 3 * 4 + 2 * 4));
    EXPECT_NEAR(node_areas(mesh.positions, surface.triangles).sum(), 2 * (2 + 6 + 3), 1e-13);
    double volume = 0;  // by the divergence theorem
    for (const auto& nodes : surface.triangles.colwise()) {
      const Eigen::Matrix3d x = mesh.positions(Eigen::all, nodes);
      volume += x.determinant() / 6;
    }
    EXPECT_NEAR(volume, 6, 1e-13);
    // Closed: each edge is there once in each direction.
    std::set<std::pair<int, int>> edges;
    for (const auto& nodes : surface.triangles.colwise()) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(edges.insert({nodes(i), nodes((i + 1) % 3)}).second);
      }
    }
    for (const auto& [from, to] : edges) EXPECT_TRUE(edges.contains({to, from}));
  }
}

TEST(ShakenInside, MovesOnlyNodesInsideAndTurnsNothingInsideOut) {
  for (const VolumeMesh& mesh : blocks()) {
    const VolumeMesh shaken = shaken_inside(mesh, 0.2, 1);
    EXPECT_TRUE(find_volume_problems(shaken).empty());
    EXPECT_NEAR(element_volumes(shaken).sum(), 6, 1e-13);
    const Eigen::VectorXd ways = (shaken.positions - mesh.positions).colwise().norm();
    EXPECT_EQ((ways.array() > 0).count(), 1 * 2 * 3);
    EXPECT_LT(ways.maxCoeff(), 0.2 * 0.5 * std::sqrt(3.0));
    EXPECT_TRUE(shaken_inside(mesh, 0.2, 1).positions == shaken.positions);
  }
}

TEST(NodesAt, AreThoseOfASide) {
  for (const VolumeMesh& mesh : blocks()) {
    EXPECT_EQ(nodes_at(mesh, 2, 3).size(), 3U * 4U);
    EXPECT_TRUE(nodes_at(mesh, 0, 0.3).empty());
  }
}

}  // namespace
}  // namespace pliant
