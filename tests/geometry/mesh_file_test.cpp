#include "pliant/geometry/mesh_file.h"

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const MeshFileOptions kMetres{.unit = 1};
const MeshFileOptions kMetresUv{.unit = 1, .rest = RestShape::uv};

/// A rectangle of 2 x 1 as one quad, with texture coordinates of the same size.
const std::string kQuad = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\n";
const std::string kFace = "f 1/1 2/2 3/3 4/4\n";

/// Two squares that share a side in space; `uv` are the eight texture points of their corners.
std::string two_squares(const std::string& uv) {
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n" + uv +
         "f 1/1 2/2 3/3 4/4\nf 2/5 5/6 6/7 3/8\n";
}

class MeshFileTest : public testing::Test {
 protected:
  MeshFile read(const std::string& obj, const MeshFileOptions& options) const {
    return read_mesh_file(folder_.write("a.obj", obj), options);
  }
  InputError error_of(const std::string& obj, const MeshFileOptions& options) const {
    return input_error_of([&] { read(obj, options); });
  }
  TemporaryFolder folder_;
};

TEST_F(MeshFileTest, IsInMetres) {
  const MeshFile sheet = read(kQuad + kFace, {.unit = 0.01, .rest = RestShape::uv});
  EXPECT_EQ(sheet.mesh.vertex_count(), 4);
  EXPECT_EQ(sheet.mesh.triangle_count(), 2);
  EXPECT_NEAR(rest_area(sheet.mesh), 2e-4, 1e-18);
  EXPECT_NEAR(sheet.mesh.positions(0, 1), 0.02, 1e-17);
  EXPECT_THAT(sheet.numbering.faces, ElementsAre(0, 0));
  EXPECT_THAT(sheet.warnings, IsEmpty());
}

TEST_F(MeshFileTest, IsRefusedWithoutUnit) {
  EXPECT_EQ(error_of(kQuad + kFace, {}).where().field, "unit");
  EXPECT_EQ(error_of(kQuad + kFace, {.unit = -1}).where().field, "unit");
}

TEST_F(MeshFileTest, IsTurnedSoThatItsUpIsZ) {
  const std::string axes = "v 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
  const std::pair<const char*, int> cases[] = {{"x", 0}, {"y", 1}, {"z", 2}};
  for (const auto& [up, vertex] : cases) {
    const Eigen::Matrix3d up_axes = read(axes, {.unit = 1, .up = up}).mesh.positions;
    EXPECT_EQ(up_axes.col(vertex), Eigen::Vector3d(0, 0, 1));
    EXPECT_NEAR(up_axes.determinant(), 1, 1e-15);  // no mirror image
    const Eigen::Matrix3d down =
        read(axes, {.unit = 1, .up = std::string("-") + up}).mesh.positions;
    EXPECT_EQ(down.col(vertex), Eigen::Vector3d(0, 0, -1));
    EXPECT_NEAR(down.determinant(), 1, 1e-15);
  }
  // As Blender imports a file whose y is up.
  EXPECT_EQ(read(axes, {.unit = 1, .up = "y"}).mesh.positions.col(2), Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(error_of(axes, {.unit = 1, .up = "w"}).where().field, "up");
}

TEST_F(MeshFileTest, KeepsTheRestPlanesOfSewnPanelsApart) {
  const MeshFile sheet = read(
      two_squares("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\nvt 6 5\nvt 6 6\nvt 5 6\n"), kMetresUv);
  EXPECT_EQ(sheet.mesh.rest_triangle(2).col(0), Eigen::Vector2d(5, 5));
  EXPECT_EQ(sheet.mesh.triangles(0, 2), 1);
  EXPECT_THAT(find_panels(sheet.mesh), ElementsAre(0, 0, 1, 1));
}

TEST_F(MeshFileTest, ScalesItsTextureCoordinates) {
  const MeshFile sheet =
      read(kQuad + kFace, {.unit = 0.01, .rest = RestShape::uv, .uv_scale = 0.011});
  EXPECT_NEAR(rest_area(sheet.mesh), 2 * 0.011 * 0.011, 1e-18);
  ASSERT_EQ(sheet.warnings.size(), 1u);
  EXPECT_THAT(sheet.warnings[0], HasSubstr("starts compressed"));
  EXPECT_EQ(
      error_of(kQuad + kFace, {.unit = 1, .rest = RestShape::uv, .uv_scale = 0.0}).where().field,
      "uv_scale");
}

TEST_F(MeshFileTest, RefusesPackedTextureCoordinatesWithTheNumbers) {
  // 1.2 m x 0.6 m packed into a square of 0.3 units.
  const InputError error = error_of(
      "v 0 0 0\nv 120 0 0\nv 120 60 0\nv 0 60 0\nvt 0 0\nvt 0.3 0\nvt 0.3 0.3\nvt 0 0.3\n" + kFace,
      {.unit = 0.01, .rest = RestShape::uv});
  EXPECT_EQ(error.where().field, "uv_scale");
  EXPECT_THAT(error.problem(), AllOf(HasSubstr("0.72 m^2"), HasSubstr("packed or scaled")));
  // sqrt(0.72 / 0.09) = 2.828 m a unit.
  EXPECT_THAT(error.expected(), HasSubstr("uv_scale: 2.828 m"));
}

TEST_F(MeshFileTest, RefusesAPanelOfAnotherScale) {
  const InputError error = error_of(
      two_squares("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\nvt 5.4 5\nvt 5.4 5.4\nvt 5 5.4\n"),
      kMetresUv);
  EXPECT_THAT(error.problem(), HasSubstr("the panel of face 2 covers 1 m^2"));
}

TEST_F(MeshFileTest, RefusesTextureCoordinatesWithoutArea) {
  const InputError error =
      error_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n", kMetresUv);
  EXPECT_EQ(error.where().field, "uv_scale");
}

TEST_F(MeshFileTest, ReversesFacesThatAllRunClockwiseAtRest) {
  const MeshFile sheet = read(kQuad + "f 4/4 3/3 2/2 1/1\n", kMetresUv);
  EXPECT_NEAR(rest_area(sheet.mesh), 2, 1e-15);
  // Weft and warp keep their directions.
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(sheet.mesh.rest_triangle(0).col(k),
              sheet.mesh.positions.col(sheet.mesh.triangles(k, 0)).head<2>());
  }
  ASSERT_EQ(sheet.warnings.size(), 1u);
  EXPECT_THAT(sheet.warnings[0], HasSubstr("clockwise"));
  EXPECT_NEAR(rest_area(read("v 0 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n", kMetres).mesh), 0.5, 1e-15);
}

TEST_F(MeshFileTest, RefusesMirroredPanelsAmongOthersByFace) {
  const InputError error = error_of(
      two_squares("vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 6 5\nvt 5 5\nvt 5 6\nvt 6 6\n"), kMetresUv);
  EXPECT_EQ(error.where().line, 16);  // the second face
  EXPECT_THAT(error.problem(), HasSubstr("face 2 runs clockwise"));
}

TEST_F(MeshFileTest, NeedsATextureCoordinateForEveryCorner) {
  EXPECT_EQ(error_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", kMetresUv).where().field, "rest");
  const InputError error = error_of(kQuad + "f 1/1 2/2 3/3\nf 1/1 3 4/4\n", kMetresUv);
  EXPECT_EQ(error.where().line, 10);
  EXPECT_THAT(error.problem(), HasSubstr("face 2 "));
}

TEST_F(MeshFileTest, IsCutInTheRestPlane) {
  // Folded in space, convex at rest.
  const MeshFile sheet = read(
      "v 0 0 0\nv 1 0 0.9\nv 2 0 0\nv 1 1 0\nvt 0 0\nvt 1 -1\nvt 2 0\nvt 1 1\nf 1/1 2/2 3/3 4/4\n",
      kMetresUv);
  EXPECT_EQ(sheet.mesh.triangle_count(), 2);
  EXPECT_THAT(error_of("v 0 0 0\nv 2 0 0\nv 0.5 0.5 0\nv 0 2 0\nf 1 2 3 4\n", kMetres).problem(),
              HasSubstr("not convex"));
}

TEST_F(MeshFileTest, SaysWhenItsShapeIsNotFlat) {
  const MeshFile sheet = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n", kMetres);
  ASSERT_EQ(sheet.warnings.size(), 1u);
  EXPECT_THAT(sheet.warnings[0], HasSubstr("not flat"));
}

TEST_F(MeshFileTest, IsFitForSimulation) {
  const InputError error = error_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n", {.unit = 1});
  EXPECT_THAT(error.problem(), HasSubstr("vertex 4 belongs to no triangle"));
  EXPECT_EQ(
      error_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\n", kMetres).where().line, 6);
}

TEST_F(MeshFileTest, KeepsTheVertexOrderOfASessionsRestMesh) {
  const auto path = folder_.write(
      "rest.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
      "property double z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n0.1 0 0\n0 0.1 0\n0.1 0.1 0\n3 0 1 3\n3 0 3 2\n");
  const TriangleMesh mesh = read_mesh_file(path, kMetres).mesh;
  for (int t = 0; t < 2; ++t) {
    for (int k = 0; k < 3; ++k) {  // flat, z = 0: u = x, v = y
      EXPECT_EQ(mesh.rest_triangle(t).col(k), mesh.positions.col(mesh.triangles(k, t)).head<2>());
    }
  }
}

}  // namespace
}  // namespace pliant
