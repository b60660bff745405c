// Keyword files as wholes: a material to be included, or a model to be completed.

#include "pliant/exchange/keyword_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/geometry/block_mesh.h"

#include "exchange/standard_materials.h"

namespace pliant::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(KeywordFile, WithoutAMeshIsTheMaterialAlone) {
  const Material material = neo_hookean_solid(5e4, kBulk);
  const std::string text = keyword_file(to_convert(material), KeywordTool::calculix).text;
  EXPECT_THAT(text, HasSubstr("** Neo-Hookean: Neo-Hookean for CalculiX"));
  EXPECT_THAT(text, HasSubstr("\n*MATERIAL, NAME=NEO_HOOKEAN\n*HYPERELASTIC, NEO HOOKE\n50000, "));
  for (const char* other : {"*HEADING", "*NODE", "*SOLID SECTION"}) {
    EXPECT_THAT(text, Not(HasSubstr(other)));
  }
}

TEST(KeywordFile, WithAMeshIsAModelWithItsSets) {
  const Material material = stvk_solid(2e5, 1e5);
  VolumeMesh mesh = block_of_hexahedra({1, 1, 2}, {1, 1, 2});
  mesh.labels = {1, 7};
  mesh.region_names = {{1, "lower half"}};
  mesh.groups = {{"foot", {0, 1, 2, 3}}, {"Foot", {4}}, {"nall", {5}}};
  const ConvertedSolid file = keyword_file(to_convert(material, &mesh), KeywordTool::calculix);
  EXPECT_THAT(file.lost, IsEmpty());
  EXPECT_THAT(file.text, HasSubstr("*NODE, NSET=NALL\n1, 0, 0, 0\n"));
  EXPECT_THAT(file.text, HasSubstr("\n12, 1, 1, 2\n"));
  EXPECT_THAT(file.text, HasSubstr("*ELEMENT, TYPE=C3D8, ELSET=EALL\n1, 1, 2, 4, 3, 5, 6, 8, 7\n"));
  EXPECT_THAT(file.text, HasSubstr("*ELSET, ELSET=LOWER_HALF\n1\n*ELSET, ELSET=REGION_7\n2\n"));
  EXPECT_THAT(file.text, HasSubstr("*NSET, NSET=FOOT\n5\n*NSET, NSET=FOOT_2\n1, 2, 3, 4\n"));
  EXPECT_THAT(file.text, HasSubstr("*NSET, NSET=NALL_2\n6\n"));
  EXPECT_THAT(file.text, HasSubstr("*SOLID SECTION, ELSET=EALL, MATERIAL=STVK\n"));
}

TEST(KeywordFile, CountsElementsThroughBothKinds) {
  const Material material = stvk_solid(2e5, 1e5);
  VolumeMesh mesh = block_of_hexahedra({1, 1, 2}, {1, 1, 2});
  mesh.tetrahedra.resize(4, 1);
  mesh.tetrahedra << 0, 1, 2, 4;
  const std::string text = keyword_file(to_convert(material, &mesh), KeywordTool::abaqus).text;
  EXPECT_THAT(text, HasSubstr("TYPE=C3D4, ELSET=EALL\n1, 1, 2, 3, 5\n"));
  EXPECT_THAT(text, HasSubstr("TYPE=C3D8, ELSET=EALL\n2, 1, 2, 4, 3, 5, 6, 8, 7\n3, "));
}

TEST(KeywordFile, HasHybridElementsInAbaqusWhereTheVolumeStays) {
  const Material material = solid_of({{"I1-bar", component_of({linear(5e4)})}});
  const VolumeMesh mesh = block_of_hexahedra({1, 1, 1}, {1, 1, 1});
  EXPECT_THAT(keyword_file(to_convert(material, &mesh), KeywordTool::abaqus).text,
              HasSubstr("TYPE=C3D8H,"));
  EXPECT_THAT(keyword_file(to_convert(material, &mesh), KeywordTool::calculix).text,
              HasSubstr("TYPE=C3D8,"));
}

TEST(KeywordFile, TellsOfElementsThatHaveMoreThanOneVolume) {
  const Material material = neo_hookean_solid(5e4, kBulk);
  const VolumeMesh hexahedra = block_of_hexahedra({1, 1, 1}, {1, 1, 1});
  const VolumeMesh tetrahedra = block_of_tetrahedra({1, 1, 1}, {1, 1, 1});
  const auto lost = [&](const VolumeMesh& mesh, KeywordTool tool) {
    return keyword_file(to_convert(material, &mesh), tool).lost;
  };
  EXPECT_THAT(lost(hexahedra, KeywordTool::calculix), ElementsAre(HasSubstr("a hexahedron")));
  EXPECT_THAT(lost(hexahedra, KeywordTool::abaqus), IsEmpty());
  EXPECT_THAT(lost(tetrahedra, KeywordTool::abaqus), ElementsAre(HasSubstr("a node of tetra")));
}

TEST(KeywordFile, SaysWhatIsLostInAComment) {
  Material material = neo_hookean_solid(5e4, kBulk);
  material.damping_fraction = 0.1;
  const ConvertedSolid file = keyword_file(to_convert(material), KeywordTool::abaqus);
  EXPECT_THAT(file.lost, ElementsAre("damping"));
  EXPECT_THAT(file.text, HasSubstr("\n** lost: damping\n"));
}

}  // namespace
}  // namespace pliant::test
