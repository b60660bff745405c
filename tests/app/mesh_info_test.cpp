// What `pliant info` says about mesh files.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pliant/file_info.h"
#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A rectangle of 2 x 1 as a quad and two triangles, with texture coordinates of half the size.
const std::string kSheet =
    "o cloth\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
    "vt 0 0\nvt 0.5 0\nvt 1 0\nvt 0 0.5\nvt 0.5 0.5\nvt 1 0.5\n"
    "f 1/1 2/2 5/5 4/4\nf 2/2 3/3 6/6\nf 2/2 6/6 5/5\n";

TEST(MeshInfo, TellsSizeShapeAndQuality) {
  const TemporaryFolder folder;
  const FileInfo info = describe_file(folder.write("a.obj", kSheet));
  EXPECT_EQ(info.json["type"], "mesh");
  EXPECT_EQ(info.json["vertices"], 6);
  EXPECT_EQ(info.json["faces"], 3);
  EXPECT_EQ(info.json["faces_by_corners"]["4"], 1);
  EXPECT_EQ(info.json["triangles"], 4);
  EXPECT_EQ(info.json["unit"], nullptr);
  EXPECT_EQ(info.json["max"], (std::vector<double>{2, 1, 0}));
  EXPECT_EQ(info.json["area"], 2.0);
  EXPECT_EQ(info.json["flat"], true);
  EXPECT_EQ(info.json["boundary_edges"], 6);
  EXPECT_NEAR(info.json["smallest_angle"]["rad"].get<double>(), 0.785398, 1e-6);
  EXPECT_THAT(info.json["left_out"].get<std::vector<std::string>>(), ElementsAre("1 line \"o\""));
  EXPECT_THAT(info.warnings, IsEmpty());
}

TEST(MeshInfo, TellsTheScaleOfTextureCoordinates) {
  const TemporaryFolder folder;
  const FileInfo info = describe_file(folder.write("a.obj", kSheet));
  EXPECT_EQ(info.json["texture"]["area"], 0.5);
  EXPECT_EQ(info.json["texture"]["matching_uv_scale"], 2.0);
  EXPECT_EQ(info.json["texture"]["panels"], 1);
  EXPECT_THAT(info.lines, Contains(HasSubstr("uv_scale 2 would match")));
}

TEST(MeshInfo, WarnsOfTextureCoordinatesThatAreNoRestShape) {
  const TemporaryFolder folder;
  const FileInfo info =
      describe_file(folder.write("a.obj", kSheet + "v 5 5 5\nv 6 5 5\nv 5 6 5\nf 7 8 9\n"));
  EXPECT_THAT(info.warnings, ElementsAre(HasSubstr("without texture coordinates")));
  EXPECT_EQ(info.json["texture"]["panels"], nullptr);
}

TEST(MeshInfo, WarnsOfEverythingThatMakesAMeshUnfit) {
  const TemporaryFolder folder;
  const FileInfo info = describe_file(
      folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 0\nv 2 0 0\nf 1 2 3\nf 1 2 5\n"));
  EXPECT_THAT(info.warnings, Contains(HasSubstr("vertex 4 belongs to no triangle")));
  EXPECT_THAT(info.warnings, Contains(HasSubstr("line 7: face 2 (vertices 1, 2, 5)")));
}

TEST(MeshInfo, OfAPlyFileNamesItsOtherProperties) {
  const TemporaryFolder folder;
  const FileInfo info = describe_file(folder.write(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nproperty float strain\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 2\n0 1 0 3\n3 0 1 2\n"));
  EXPECT_EQ(info.json["texture"], nullptr);
  EXPECT_THAT(info.lines, Contains(HasSubstr("\"strain\" of each vertex")));
}

TEST(MeshInfo, OfAFileThatCannotBeReadIsItsError) {
  const TemporaryFolder folder;
  const InputError error =
      input_error_of([&] { describe_file(folder.write("a.obj", "v 0 0 0\nv 0 0\n")); });
  EXPECT_EQ(error.where().line, 2);
}

}  // namespace
}  // namespace pliant::test
