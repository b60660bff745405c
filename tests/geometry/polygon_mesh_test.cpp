#include "pliant/geometry/polygon_mesh.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

/// One polygon and where its corners are.
struct Polygon {
  Polygons faces;
  Eigen::Matrix2Xd plane;
};

Polygon polygon(const std::vector<Eigen::Vector2d>& points) {
  Polygon polygon;
  std::vector<int> corners;
  polygon.plane.resize(2, static_cast<Eigen::Index>(points.size()));
  for (const Eigen::Vector2d& point : points) {
    polygon.plane.col(static_cast<Eigen::Index>(corners.size())) = point;
    corners.push_back(static_cast<int>(corners.size()));
  }
  polygon.faces.add(corners);
  return polygon;
}

TEST(CutFaces, AreFansOfTheirFirstCorner) {
  const Polygon p = polygon({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}});
  const CutFaces cut = cut_into_triangles(p.faces, p.plane, {});
  Eigen::Matrix3Xi expected(3, 3);
  expected << 0, 0, 0, 1, 2, 3, 2, 3, 4;
  EXPECT_TRUE(cut.corners == expected);
  EXPECT_THAT(cut.faces, ElementsAre(0, 0, 0));
}

TEST(CutFaces, AreFansOfACornerThatMakesNoEmptyTriangle) {
  // The second corner lies on a side: from the first or third a triangle would have no area.
  const Polygon p = polygon({{0, 0}, {1, 0}, {2, 0}, {1, 1}});
  const CutFaces cut = cut_into_triangles(p.faces, p.plane, {});
  ASSERT_EQ(cut.corners.cols(), 2);
  EXPECT_EQ(cut.corners(0, 0), 1);
  EXPECT_EQ(cut.corners(0, 1), 1);
}

TEST(CutFaces, MayRunEitherWay) {
  const Polygon p = polygon({{0, 2}, {2, 2}, {2, 0}, {0, 0}});
  EXPECT_EQ(cut_into_triangles(p.faces, p.plane, {}).corners.cols(), 2);
}

TEST(CutFaces, AreNotMadeOfPolygonsThatAreNotConvex) {
  const MeshNumbering numbering{"a.obj", 1, {}, {17}};
  for (const Polygon& p :
       {polygon({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}),  // an arrow
        polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),      // a bow tie
        polygon({{0, 1}, {0.6, -0.8}, {-0.95, 0.3}, {0.95, 0.3}, {-0.6, -0.8}})}) {
    const InputError error =
        input_error_of([&] { cut_into_triangles(p.faces, p.plane, numbering); });
    EXPECT_EQ(error.where().line, 17);
    EXPECT_THAT(error.problem(), HasSubstr("face 1 "));
    EXPECT_THAT(error.problem(), HasSubstr("not convex"));
  }
}

TEST(CutFaces, HaveALimitedNumberOfCorners) {
  std::vector<Eigen::Vector2d> circle;
  for (int i = 0; i < 300; ++i) circle.emplace_back(std::cos(i / 50.0), std::sin(i / 50.0));
  const Polygon p = polygon(circle);
  EXPECT_THAT(input_error_of([&] { cut_into_triangles(p.faces, p.plane, {}); }).problem(),
              HasSubstr("300 corners"));
}

TEST(FacePlanes, KeepTheSizeAndFormOfAFace) {
  PolygonMesh mesh;
  mesh.positions.resize(3, 4);
  mesh.positions << 1, 1, 1, 1, 0, 3, 3, 0, 0, 0, 4, 4;
  mesh.faces.add(std::vector{0, 1, 2, 3});
  const Eigen::Matrix2Xd plane = face_planes(mesh);
  EXPECT_NEAR((plane.col(1) - plane.col(0)).norm(), 3, 1e-15);
  EXPECT_NEAR((plane.col(2) - plane.col(0)).norm(), 5, 1e-15);
  EXPECT_EQ(cut_into_triangles(mesh.faces, plane, {}).corners.cols(), 2);
}

TEST(PolygonMesh, OfAnObjFileHasTheTextureOfItsCorners) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.OBJ",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0.5 0.25\nvn 0 0 1\n"
                                 "g hem\nf 1/1/1 2//1 3/1/1\n");
  const PolygonMesh mesh = read_polygon_mesh(path);
  EXPECT_EQ(mesh.numbering.first, 1);
  EXPECT_EQ(mesh.numbering.line_of_face(0), 7);
  EXPECT_EQ(mesh.numbering.groups, (VertexGroups{{"hem", {0, 1, 2}}}));
  ASSERT_TRUE(mesh.has_texture());
  EXPECT_EQ(mesh.texture.col(2), Eigen::Vector2d(0.5, 0.25));
  EXPECT_TRUE(mesh.texture.col(1).hasNaN());
  EXPECT_THAT(mesh.ignored, ElementsAre("1 line \"vn\""));
}

TEST(PolygonMesh, OfAPlyFileCountsFromZero) {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty uchar red\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 0\n0 1 0 3\n3 0 1 2\n");
  const PolygonMesh mesh = read_polygon_mesh(path);
  EXPECT_EQ(mesh.numbering.first, 0);
  EXPECT_FALSE(mesh.has_texture());
  EXPECT_EQ(mesh.positions.col(1), Eigen::Vector3d(1, 0, 0));
  EXPECT_THAT(mesh.ignored, ElementsAre("\"red\" of each vertex"));
  EXPECT_EQ(mesh.numbering.groups, (VertexGroups{{"red", {0, 2}}}));
}

TEST(PolygonMesh, NeedsFacesAndAKnownName) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      input_error_of([&] { read_polygon_mesh(folder.write("a.obj", "v 0 0 0\n")); }).problem(),
      HasSubstr("no faces"));
  EXPECT_THAT(input_error_of([&] { read_polygon_mesh(folder.write("a.stl", "")); }).problem(),
              HasSubstr("\".stl\""));
  EXPECT_TRUE(is_mesh_file("shirt.Ply"));
  EXPECT_FALSE(is_mesh_file("ply"));
}

}  // namespace
}  // namespace pliant
