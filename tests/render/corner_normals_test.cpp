#include "pliant/render/corner_normals.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
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

/// Two triangles that meet on the y axis, of which the second has turned up by an angle.
struct Fold {
  Eigen::Matrix3Xf positions{3, 4};
  Eigen::Matrix3Xi triangles{3, 2};

  explicit Fold(double degrees) {
    const auto angle = static_cast<float>(degrees * std::numbers::pi / 180);
    positions << 0, 0, -1, std::cos(angle),  //
        0, 1, 0.5F, 0.5F,                    //
        0, 0, 0, std::sin(angle);
    triangles << 0, 1, 1, 0, 2, 3;
  }
};

TEST(CornerNormals, AreSharedOverAFold) {
  const Fold fold(60);
  const CornerNormals normals = corner_normals(fold.positions, fold.triangles);
  EXPECT_EQ(normals.normals.cols(), 4);
  EXPECT_EQ(normals.corners(0, 0), normals.corners(1, 1));
  EXPECT_EQ(normals.corners(1, 0), normals.corners(0, 1));
}

TEST(CornerNormals, AreThoseOfFlatTrianglesAtACrease) {
  const Fold fold(90);
  const CornerNormals normals = corner_normals(fold.positions, fold.triangles);
  EXPECT_EQ(normals.normals.cols(), 6);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3f first = normals.normals.col(normals.corners(k, 0));
    const Eigen::Vector3f second = normals.normals.col(normals.corners(k, 1));
    EXPECT_LT((first - Eigen::Vector3f::UnitZ()).norm(), kRounding);
    EXPECT_LT((second + Eigen::Vector3f::UnitX()).norm(), kRounding);
  }
}

TEST(CornerNormals, AreNotSharedWhereAFrontMeetsABack) {
  Fold fold(0);
  fold.triangles.col(1).reverseInPlace();
  EXPECT_EQ(corner_normals(fold.positions, fold.triangles).normals.cols(), 6);
}

TEST(CornerNormals, AreNotSharedOverAnEdgeOfThreeTriangles) {
  Fold fold(0);
  fold.positions.conservativeResize(3, 5);
  fold.positions.col(4) << 1, 0.5F, 0.2F;
  fold.triangles.conservativeResize(3, 3);
  fold.triangles.col(2) << 1, 0, 4;
  EXPECT_EQ(corner_normals(fold.positions, fold.triangles).normals.cols(), 9);
}

TEST(CornerNormals, AreTheMeanOfTheVertexNormalsOfTheTrianglesAround) {
  const Fold fold(60);
  const Eigen::Matrix3Xf plain = vertex_normals(fold.positions, fold.triangles);
  const CornerNormals normals = corner_normals(fold.positions, fold.triangles);
  const Eigen::Vector3f at_tip = normals.normals.col(normals.corners(2, 0));
  EXPECT_LT((at_tip - plain.leftCols<3>().rowwise().sum().normalized()).norm(), kRounding);
  EXPECT_GT((at_tip - plain.col(2)).norm(), 0.1F);
}

}  // namespace
}  // namespace pliant
