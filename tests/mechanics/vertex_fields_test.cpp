#include "pliant/mechanics/vertex_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/geometry/regular_grid.h"

#include "support/cloth_systems.h"

namespace pliant {
namespace {

using testing::Key;
using testing::UnorderedElementsAre;

TEST(VertexFields, AreTheStrainAndFrictionOfAUniformStretch) {
  TriangleMesh mesh = regular_grid(0.1, 0.1, 4, 4);
  mesh.positions.row(0) *= 1.1;  // along weft
  test::ClothSystem sheet = test::cloth_system(mesh, test::frictional_cotton());
  sheet.system->finish();
  const auto fields = vertex_fields(*sheet.system, sheet.system->initial_state(), sheet.cloth.shown,
                                    0, mesh.vertex_count());
  EXPECT_THAT(fields,
              UnorderedElementsAre(Key("strain.stretch.weft"), Key("strain.stretch.warp"),
                                   Key("strain.shear"), Key("strain.bend.weft"),
                                   Key("strain.bend.warp"), Key("strain.bend.diagonal"),
                                   Key("friction.stretch.weft"), Key("friction.stretch.warp"),
                                   Key("friction.shear"), Key("friction.bend.weft"),
                                   Key("friction.bend.warp"), Key("friction.bend.diagonal")));
  const double strain = (1.1 * 1.1 - 1) / 2;
  const double friction = friction_stress(DahlParameters{2.22, 3.16, 0.006}, strain, {}).stress;
  EXPECT_TRUE(fields.at("strain.stretch.weft").isApproxToConstant(strain, 1e-12));
  EXPECT_TRUE(fields.at("friction.stretch.weft").isApproxToConstant(friction, 1e-12));
  EXPECT_LT(fields.at("strain.stretch.warp").cwiseAbs().maxCoeff(), 1e-12);
}

TEST(VertexFields, OfASecondClothStandAtItsOwnVertices) {
  const TriangleMesh mesh = regular_grid(0.1, 0.1, 3, 3);
  TriangleMesh stretched = mesh;
  stretched.positions.row(1) *= 1.2;
  Eigen::Matrix3Xd positions(3, 18);
  positions << mesh.positions, stretched.positions;
  System system(positions, Eigen::VectorXd::Ones(18));
  std::vector<int> all{0, 1, 2, 3, 4, 5, 6, 7};
  add_cloth(system, mesh, 0, test::frictional_cotton(), all, {});
  const Cloth second = add_cloth(system, mesh, 9, test::frictional_cotton(), all, {});
  system.finish();
  const auto fields = vertex_fields(system, system.initial_state(), second.shown, 9, 9);
  EXPECT_TRUE(fields.at("strain.stretch.warp").isApproxToConstant((1.44 - 1) / 2, 1e-12));
}

}  // namespace
}  // namespace pliant
