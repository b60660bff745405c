#include "pliant/render/surface.h"

#include <gtest/gtest.h>

#include "render/small_scenes.h"

namespace pliant {
namespace {

// Of rounding in single precision.
constexpr float kRounding = 1e-6F;

/// A fold over the y axis whose two faces slope down by 27 degrees.
RenderMesh ridge() {
  RenderMesh mesh;
  mesh.positions.resize(3, 4);
  mesh.positions << 0, 0, -1, 1,  //
      0, 1, 0.5, 0.5,             //
      0, 0, -0.5, -0.5;
  mesh.triangles.resize(3, 2);
  mesh.triangles << 0, 1, 1, 0, 2, 3;
  return mesh;
}

RayHit hit_on_ridge(const Eigen::Vector3f& barycentric) {
  const Eigen::Vector3f normal = Eigen::Vector3f(-1, 0, 2).normalized();
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
  EXPECT_GT(lift.dot(in_middle.normal), 0.05F);
}

TEST(Surface, HasTheColourOfTheSideThatIsSeen) {
  const Surface surface(ridge(), ridge().positions.cast<float>());
  RayHit hit = hit_on_ridge({0.2F, 0.2F, 0.6F});
  EXPECT_EQ(surface.colour(hit, 0), ridge().front);
  hit.front = false;
  EXPECT_EQ(surface.colour(hit, 0), ridge().back);
}

TEST(Surface, IsDarkerOnTheLinesOfItsRestShape) {
  RenderMesh mesh = ridge();
  mesh.lines = RestLines{Eigen::Matrix2Xd::Zero(2, 6), 0.1};
  mesh.lines->rest_corners.row(0) << 0, 0, -0.14, 0, 0, 0.14;
  mesh.lines->rest_corners.row(1) << 0.01, 0.09, 0.05, 0.09, 0.01, 0.05;
  const Surface surface(mesh, mesh.positions.cast<float>());
  const Colour on_line = surface.colour(hit_on_ridge({0.5F, 0.5F, 0}), 0);
  const Colour beside = surface.colour(hit_on_ridge({0.25F, 0.25F, 0.5F}), 0);
  EXPECT_EQ(beside, mesh.front);
  EXPECT_LT(on_line.sum(), 0.7F * beside.sum());
}

}  // namespace
}  // namespace pliant
