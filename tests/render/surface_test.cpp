#include "pliant/render/surface.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "render/small_scenes.h"

namespace pliant {
namespace {

// Of rounding in single precision.
constexpr float kRounding = 1e-6F;

TEST(VertexNormals, OfAPlaneAreItsNormal) {
  const RenderMesh mesh = test::rectangle({0, 0, 0}, {2, 0, 0}, {1, 1, 0});
  const Eigen::Matrix3Xf normals = vertex_normals(mesh.positions.cast<float>(), mesh.triangles);
  for (const auto& normal : normals.colwise()) {
    EXPECT_LT((normal - Eigen::Vector3f::UnitZ()).norm(), kRounding);
  }
}

// Three faces of a cube meet at a corner, one of them cut into two triangles: by the angles the cut
// does not matter.
TEST(VertexNormals, WeighFacesByTheirAngle) {
  Eigen::Matrix3Xf positions(3, 5);
  positions << 0, 1, 0, 0, 1,  //
      0, 0, 1, 0, 1,           //
      0, 0, 0, 1, 0;
  Eigen::Matrix3Xi triangles(3, 4);
  triangles << 0, 0, 0, 0,  //
      4, 2, 3, 1,           //
      1, 4, 2, 3;
  const Eigen::Vector3f normal = vertex_normals(positions, triangles).col(0);
  EXPECT_LT((normal - Eigen::Vector3f::Constant(-1 / std::sqrt(3.0F))).norm(), kRounding);
}

TEST(VertexNormals, OfAVertexWithoutAreaAreZero) {
  Eigen::Matrix3Xf positions = Eigen::Matrix3Xf::Zero(3, 4);
  positions.col(1).x() = 1;
  positions.col(2).x() = 2;
  Eigen::Matrix3Xi triangles(3, 1);
  triangles << 0, 1, 2;
  EXPECT_EQ(vertex_normals(positions, triangles), Eigen::Matrix3Xf(Eigen::Matrix3Xf::Zero(3, 4)));
}

/// A fold over the y axis whose two faces slope down by 45 degrees.
RenderMesh ridge() {
  RenderMesh mesh;
  mesh.positions.resize(3, 4);
  mesh.positions << 0, 0, -1, 1,  //
      0, 1, 0.5, 0.5,             //
      0, 0, -1, -1;
  mesh.triangles.resize(3, 2);
  mesh.triangles << 0, 1, 1, 0, 2, 3;
  return mesh;
}

RayHit hit_on_ridge(const Eigen::Vector3f& barycentric) {
  const Eigen::Vector3f normal = Eigen::Vector3f(-1, 0, 1).normalized();
  return {0, 0, barycentric, normal, 1};
}

TEST(Surface, HasANormalOnTheSideThatIsSeen) {
  const Surface surface(ridge(), ridge().positions.cast<float>());
  RayHit hit = hit_on_ridge({0.5F, 0.5F, 0});
  EXPECT_LT((surface.normal(hit) - Eigen::Vector3f::UnitZ()).norm(), kRounding);
  hit.normal = -hit.normal;
  EXPECT_LT((surface.normal(hit) + Eigen::Vector3f::UnitZ()).norm(), kRounding);
}

TEST(Surface, RoundsAConvexTriangleOutwardsAndKeepsItsCorners) {
  const Surface surface(ridge(), ridge().positions.cast<float>());
  const auto point_at = [&](const Eigen::Vector3f& barycentric) -> Eigen::Vector3f {
    return surface.positions()(Eigen::all, Eigen::Vector3i(0, 1, 2)) * barycentric;
  };
  const Eigen::Vector3f corner(1, 0, 0), middle = Eigen::Vector3f::Constant(1.0F / 3);
  const RayHit at_corner = hit_on_ridge(corner), in_middle = hit_on_ridge(middle);
  EXPECT_LT((surface.rounded_point(at_corner, point_at(corner)) - point_at(corner)).norm(),
            kRounding);
  const Eigen::Vector3f lift =
      surface.rounded_point(in_middle, point_at(middle)) - point_at(middle);
  EXPECT_GT(lift.dot(in_middle.normal), 0.1F);
}

}  // namespace
}  // namespace pliant
