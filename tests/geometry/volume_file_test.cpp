#include "pliant/geometry/volume_file.h"

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/block_mesh.h"
#include "pliant/io/gmsh.h"
#include "pliant/io/medit.h"

#include "io/temporary_folder.h"

namespace pliant {
namespace {

constexpr const char* kGmsh2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"base\"\n3 4 \"soft\"\n"
    "$EndPhysicalNames\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n10 1 1 1\n$EndNodes\n"
    "$Elements\n3\n1 2 2 7 1 1 3 2\n2 4 2 4 1 1 2 3 4\n3 4 2 0 1 2 10 3 4\n$EndElements\n";

constexpr const char* kGmsh4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"base\"\n3 4 \"soft\"\n"
    "$EndPhysicalNames\n$Entities\n0 0 1 2\n1 0 0 0 1 1 0 1 7 0\n1 0 0 0 1 1 1 1 4 0\n"
    "2 0 0 0 1 1 1 0 0\n$EndEntities\n$Nodes\n1 5 1 10\n3 1 0 5\n1\n2\n3\n4\n10\n0 0 0\n1 0 0\n"
    "0 1 0\n0 0 1\n1 1 1\n$EndNodes\n$Elements\n3 3 1 3\n2 1 2 1\n1 1 3 2\n3 1 4 1\n2 1 2 3 4\n"
    "3 2 4 1\n3 2 10 3 4\n$EndElements\n";

TEST(Gmsh, ReadsElementsLabelsAndGroupsOfBothFormats) {
  for (const char* text : {kGmsh2, kGmsh4}) {
    const VolumeData data = parse_gmsh(text, "x.msh");
    EXPECT_EQ(data.points.size(), 5U);
    EXPECT_EQ(data.points[4], (Point3{1, 1, 1}));
    const std::vector<std::array<int, 4>> expected{{0, 1, 2, 3}, {1, 4, 2, 3}};
    EXPECT_EQ(data.tetrahedra.corners, expected);
    EXPECT_EQ(data.tetrahedra.labels, (std::vector<int>{4, 0}));
    EXPECT_EQ(data.region_names.at(4), "soft");
    EXPECT_EQ(data.groups.at("base"), (std::vector<int>{0, 1, 2}));
    EXPECT_TRUE(data.ignored.empty());
  }
}

void refuse(const std::string& text, int line, const std::string& part) {
  try {
    parse_gmsh(text, "x.msh");
    ADD_FAILURE() << part;
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, line) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Gmsh, RefusesWhatItCannotRead) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  refuse("", 1, "is empty");
  refuse("v 0 0 0\n", 1, "does not begin as a mesh of gmsh");
  refuse("$MeshFormat\n3.0 0 8\n", 2, "format 3");
  refuse("$MeshFormat\n2.2 1 8\n", 2, "binary");
  refuse(head + "$Nodes\n2\n1 0 0 0\n", 7, "ends too early");
  refuse(head + "$Nodes\n1\n1 0 zero 0\n", 6, "\"zero\" is no number");
  refuse(head + "$Elements\n1\n1 4 2 0 0 1 2 3 4\n", 6, "there is no node 1");
  refuse(head + "$Elements\n1\n1 6 2 0 0 1 2 3 4 5 6\n", 6, "holds prisms");
  refuse(head + "$Elements\n1\n1 11 2 0 0\n", 6, "elements of type 11");
}

TEST(Medit, RefusesWhatItCannotRead) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parse_medit(text, "x.mesh");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("solid").find("does not begin"), std::string::npos);
  const std::string head = "MeshVersionFormatted 2 # by hand\nDimension 3\nVertices\n1\n0 0 0 0\n";
  EXPECT_EQ(message(head + "End\n"), "");
  EXPECT_NE(message(head + "Tetrahedra\n1\n1 2 3 4 0\n").find("there is no vertex 2"),
            std::string::npos);
  EXPECT_NE(message(head + "Prisms\n1\n1 1 1 1 1 1 0\n").find("\"Prisms\" is not known"),
            std::string::npos);
}

TEST(VolumeFiles, ReadBackWhatTheyWrite) {
  const test::TemporaryFolder folder;
  for (VolumeMesh mesh : {shaken_inside(block_of_tetrahedra({0.3, 0.1, 0.7}, {2, 3, 2}), 0.2, 3),
                          shaken_inside(block_of_hexahedra({0.3, 0.1, 0.7}, {2, 3, 2}), 0.2, 3)}) {
    for (int e = 0; e < mesh.element_count(); ++e) mesh.labels.push_back(e % 3);
    mesh.groups = {{"clamp", {0, 3, 4}}, {"tip", {3, 7}}};
    for (const char* name : {"block.msh", "block.mesh"}) {
      const VolumeMesh read =
          read_volume_mesh(folder.write(name, volume_file_text(mesh, name)), {.unit = 1});
      EXPECT_TRUE(read.positions == mesh.positions) << name;
      EXPECT_TRUE(read.tetrahedra == mesh.tetrahedra) << name;
      EXPECT_TRUE(read.hexahedra == mesh.hexahedra) << name;
      EXPECT_EQ(read.labels, mesh.labels) << name;
      const bool has_groups = name == std::string("block.msh");
      EXPECT_EQ(read.groups, has_groups ? mesh.groups : decltype(mesh.groups){}) << name;
    }
  }
}

TEST(VolumeFiles, AreTurnedAndScaledAsAsked) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("two.msh", kGmsh2);
  const VolumeMesh mesh = read_volume_mesh(path, {.unit = 0.001, .up = "y"});
  EXPECT_TRUE(mesh.positions.col(2).isApprox(Eigen::Vector3d(0, 0, 0.001)));
  EXPECT_THROW(read_volume_mesh(path, {}), InputError);
  EXPECT_THROW(read_volume_mesh(folder.write("two.stl", kGmsh2), {.unit = 1}), InputError);
}

TEST(VolumeFiles, AreRefusedByTheLineOfABadElement) {
  const test::TemporaryFolder folder;
  std::string text = kGmsh2;
  text.replace(text.find("1 2 3 4\n3 4"), 7, "2 1 3 4");
  try {
    read_volume_mesh(folder.write("two.msh", text), {.unit = 1});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, 20);
    EXPECT_NE(error.problem().find("tetrahedron 1 is turned inside out"), std::string::npos);
  }
}

}  // namespace
}  // namespace pliant
