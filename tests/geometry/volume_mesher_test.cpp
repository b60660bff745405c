#include "pliant/geometry/volume_mesher.h"

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/irregular_mesh.h"
#include "pliant/geometry/volume_quality.h"

namespace pliant {
namespace {

/// The surface of a block, and what fills it.
struct Block {
  VolumeMesh mesh = block_of_hexahedra({1, 1, 2}, {1, 1, 1});
  Eigen::Matrix3Xi surface = boundary_surface(mesh).triangles;
};

class VolumeMesher : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  }
};

TEST_F(VolumeMesher, FillsABlockWithGoodTetrahedraOfTheSizeAskedFor) {
  const Block block;
  const VolumeMesh filled = fill_surface(block.mesh.positions, block.surface, 0.25);
  EXPECT_TRUE(find_volume_problems(filled).empty());
  EXPECT_NEAR(element_volumes(filled).sum(), 2, 1e-9);  // its edges are kept
  const VolumeQuality quality = volume_quality(filled);
  EXPECT_NEAR(quality.mean_edge, 0.25, 0.05);
  EXPECT_GT(quality.least_shape, 0.1);  // its worst are not moved: that would go by addresses
  EXPECT_GT(quality.mean_shape, 0.7);
}

TEST_F(VolumeMesher, MakesTheSameMeshOfTheSameSurface) {
  const Block block;
  const VolumeMesh one = fill_surface(block.mesh.positions, block.surface, 0.4);
  const VolumeMesh other = fill_surface(block.mesh.positions, block.surface, 0.4);
  EXPECT_TRUE(one.positions == other.positions);
  EXPECT_TRUE(one.tetrahedra == other.tetrahedra);
}

TEST_F(VolumeMesher, TakesASurfaceThatRunsTheOtherWay) {
  Block block;
  block.surface.row(1).swap(block.surface.row(2));
  const VolumeMesh filled = fill_surface(block.mesh.positions, block.surface, 0.5);
  EXPECT_TRUE(find_volume_problems(filled).empty());
  EXPECT_NEAR(element_volumes(filled).sum(), 2, 1e-9);
}

TEST_F(VolumeMesher, RefusesASurfaceThatIsNotClosedWithItsOpenEdges) {
  const Block block;
  try {
    fill_surface(block.mesh.positions, block.surface.leftCols(11), 0.25, "box.obj");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().file, "box.obj");
    EXPECT_EQ(error.problem().find("the surface is not closed: 3 edges"), 0U) << error.problem();
  }
}

}  // namespace
}  // namespace pliant
