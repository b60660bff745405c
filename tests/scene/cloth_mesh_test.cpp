// The meshes that scenes ask for, and the materials of their triangles.

#include "pliant/scene/cloth_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/geometry/irregular_mesh.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

MeshSource grid_of(int nodes_u, int nodes_v) {
  return {GridMesh{0.1, 0.05, nodes_u, nodes_v, Diagonals::rising}, {"scene.yaml", 4, "mesh"}};
}

MeshSource file_of(const std::filesystem::path& path) {
  MeshFileOptions options;
  options.unit = 0.01;
  return {FileMesh{path, options}, {"scene.yaml", 4, "mesh"}};
}

// A square and a triangle beside it.
constexpr const char* kFaces = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n";

SceneCloth with_regions(const std::vector<std::vector<int>>& regions) {
  SceneCloth cloth;
  for (const std::vector<int>& faces : regions) {
    cloth.regions.push_back({{}, {faces, {}, {"scene.yaml", 4, "cloth[0].regions"}}});
  }
  return cloth;
}

TEST(ClothMesh, OfAGridIsTheGrid) {
  const ClothMesh cloth = make_cloth_mesh(grid_of(3, 2));
  EXPECT_EQ(cloth.mesh.vertex_count(), 6);
  EXPECT_EQ(cloth.mesh.triangle_count(), 4);
  EXPECT_NEAR(rest_area(cloth.mesh), 0.005, 1e-17);
}

TEST(ClothMesh, OfARectangleFillsIt) {
  if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  const ClothMesh cloth =
      make_cloth_mesh({RectangleMesh{0.1, 0.05, 0.01}, {"scene.yaml", 4, "mesh"}});
  EXPECT_NEAR(rest_area(cloth.mesh), 0.005, 1e-12);
}

TEST(ClothMesh, OfATubeIsClosed) {
  const ClothMesh cloth = make_cloth_mesh(
      {TubeMesh{0.1, 0.05, 6, 3, Diagonals::alternating}, {"scene.yaml", 4, "mesh"}});
  EXPECT_EQ(cloth.mesh.vertex_count(), 18);
  EXPECT_EQ(cloth.mesh.triangle_count(), 24);
  EXPECT_NEAR(rest_area(cloth.mesh), 0.005, 1e-17);
}

TEST(ClothMesh, OfAFileIsInMetres) {
  const TemporaryFolder folder;
  const ClothMesh cloth = make_cloth_mesh(file_of(folder.write("sheet.obj", kFaces)));
  EXPECT_EQ(cloth.mesh.triangle_count(), 3);
  EXPECT_NEAR(rest_area(cloth.mesh), 1.5e-4, 1e-18);
}

TEST(ClothMesh, OfTheSizeOfACrumbIsAskedForItsUnit) {
  const TemporaryFolder folder;
  MeshSource source = file_of(folder.write("sheet.obj", kFaces));
  EXPECT_THAT(make_cloth_mesh(source).warnings, IsEmpty());
  std::get<FileMesh>(source.kind).options.unit = 1e-3;
  EXPECT_THAT(make_cloth_mesh(source).warnings,
              ElementsAre(HasSubstr("the cloth measures 1.5 mm^2: is `unit` 1 m, not 1 mm")));
}

TEST(ClothMesh, OfABadFileIsRefusedWithThatFile) {
  const TemporaryFolder folder;
  const auto path = folder.write("sheet.obj", "v 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(input_error_of([&] { make_cloth_mesh(file_of(path)); }).where().file, path.string());
}

TEST(MaterialOfTriangles, IsTheClothsOwnOutsideOfRegions) {
  const ClothMesh mesh = make_cloth_mesh(grid_of(3, 2));
  EXPECT_THAT(material_of_triangles(with_regions({{1, 3}, {0}}), mesh), ElementsAre(2, 1, 0, 1));
}

TEST(MaterialOfTriangles, IsThatOfTheFaceTheyWereCutFrom) {
  const TemporaryFolder folder;
  const ClothMesh mesh = make_cloth_mesh(file_of(folder.write("sheet.obj", kFaces)));
  EXPECT_THAT(material_of_triangles(with_regions({{0}}), mesh), ElementsAre(1, 1, 0));
}

TEST(MaterialOfTriangles, IsRefusedForAFaceInTwoRegions) {
  const ClothMesh mesh = make_cloth_mesh(grid_of(3, 2));
  const InputError error = input_error_of([&] {
    material_of_triangles(with_regions({{1, 3}, {3}}), mesh);
  });
  EXPECT_EQ(error.where().line, 4);
  EXPECT_EQ(error.problem(), "face 3 is listed twice");
}

TEST(MaterialOfTriangles, IsRefusedForAFaceThatIsNotThere) {
  const ClothMesh mesh = make_cloth_mesh(grid_of(3, 2));
  const InputError error = input_error_of([&] {
    material_of_triangles(with_regions({{1, 4}}), mesh);
  });
  EXPECT_EQ(error.problem(), "there is no face 4");
}

}  // namespace
}  // namespace pliant
