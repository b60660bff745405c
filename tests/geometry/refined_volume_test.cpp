#include "pliant/geometry/refined_volume.h"

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/geometry/block_mesh.h"

namespace pliant {
namespace {

std::vector<VolumeMesh> shaken_blocks() {
  std::vector<VolumeMesh> meshes{block_of_tetrahedra({0.3, 0.2, 0.1}, {3, 2, 2}),
                                 block_of_hexahedra({0.3, 0.2, 0.1}, {3, 2, 2})};
  RandomStream random(3);
  for (VolumeMesh& mesh : meshes) {
    for (double& x : mesh.positions.reshaped()) x += 0.005 * random.uniform(-1, 1);
    mesh.labels.assign(static_cast<std::size_t>(mesh.element_count()), 1);
    mesh.labels.front() = 7;
    mesh.groups["base"] = {0, 1, 2};
  }
  return meshes;
}

TEST(RefinedVolume, HasEightElementsInPlaceOfEach) {
  for (const VolumeMesh& mesh : shaken_blocks()) {
    const RefinedVolume fine = refined(mesh);
    ASSERT_EQ(fine.mesh.element_count(), 8 * mesh.element_count());
    const Eigen::VectorXd volumes = element_volumes(mesh), parts = element_volumes(fine.mesh);
    EXPECT_GT(parts.minCoeff(), 0);
    EXPECT_NEAR(parts.sum(), volumes.sum(), 1e-15);
    EXPECT_NEAR(parts.head<8>().sum(), volumes(0), 1e-16);
    for (int e = 0; e < fine.mesh.element_count(); ++e) {
      EXPECT_EQ(fine.mesh.label_of(e), mesh.label_of(e / 8));
    }
  }
}

TEST(RefinedVolume, HasTheSameSurface) {
  for (const VolumeMesh& mesh : shaken_blocks()) {
    const RefinedVolume fine = refined(mesh);
    EXPECT_TRUE(boundary_surface(fine.mesh).triangles.cols() ==
                4 * boundary_surface(mesh).triangles.cols());
  }
}

TEST(RefinedVolume, KnowsWhichNodesLieBetweenOthers) {
  const VolumeMesh mesh = block_of_hexahedra({0.3, 0.2, 0.1}, {3, 2, 2});
  const RefinedVolume fine = refined(mesh);
  EXPECT_EQ(fine.nodes(nodes_at(mesh, 0, 0)), nodes_at(fine.mesh, 0, 0));
  const RefinedVolume of_groups = refined(shaken_blocks().back());
  EXPECT_EQ(of_groups.mesh.groups.at("base").size(), 5u);  // and the middles of two edges
}

}  // namespace
}  // namespace pliant
