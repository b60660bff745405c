// `pliant info` of a scene.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/pliant/file_info.h"
#include "io/input_error_of.h"
#include "scene/scene_text.h"

namespace pliant::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;

FileInfo info_of(const std::string& scene) {
  const TemporaryFolder folder;
  folder.write("jersey.json", kJersey);
  return describe_file(folder.write("scene.yaml", scene));
}

TEST(SceneInfo, TellsWhatWouldBeSimulated) {
  const FileInfo info =
      info_of(with_more("pins: [{cloth: sheet, edges: [top]}]\n"
                        "clips: [{name: weight, cloth: sheet, edges: [bottom], mass: 10 g,\n"
                        "  free: true, cords: [{vertex: 1, force: [0, 0, -1]}]}]\n"));
  EXPECT_EQ(info.json["type"], "scene/1");
  EXPECT_EQ(info.json["cloth"][0]["triangles"], 8);
  EXPECT_NEAR(info.json["cloth"][0]["mass"].get<double>(), 0.15 * 0.01, 1e-15);
  EXPECT_EQ(info.json["pins"][0]["vertices"], 3);
  EXPECT_EQ(info.json["clips"][0]["cords"], 1);
  EXPECT_EQ(info.json["steps"], 200);
  EXPECT_EQ(info.json["frames"], 26);
  EXPECT_THAT(info.lines, Contains(HasSubstr("grid 100 mm x 100 mm, 3 x 3 nodes")));
  EXPECT_THAT(info.lines, Contains(HasSubstr("200 steps of 5 ms")));
}

TEST(SceneInfo, TellsWhatIsInTheWay) {
  const FileInfo info = info_of(
      with_more("obstacles:\n"
                "  - {name: floor, plane: {point: [0, 0, -1], normal: [0, 0, 2]}, friction: 0.5}\n"
                "  - {name: ball, sphere: {centre: [0, 0, -0.3], radius: 200 mm},\n"
                "     friction: {static: 0.4, kinetic: 0.3}}\n"
                "  - {name: rod, capsule: {from: [0, 0, -0.1], to: [1, 0, -0.1], radius: 10 mm}}\n"
                "  - {name: plate, box: {centre: [0, 0, -2], size: [1, 1, 0.1]},\n"
                "     motion: {keyframes: [{time: 0 s}, {time: 1 s, translate: [0, 0, 1]}]}}\n"
                "contact: {thickness: 2 mm}\n"));
  EXPECT_EQ(info.json["obstacles"][0]["plane"]["normal"][2], 1);
  EXPECT_EQ(info.json["obstacles"][1]["friction"]["kinetic"], 0.3);
  EXPECT_EQ(info.json["obstacles"][2]["capsule"]["radius"], 0.01);
  EXPECT_EQ(info.json["obstacles"][3]["box"]["size"][2], 0.1);
  EXPECT_EQ(info.json["obstacles"][3]["moved"], true);
  EXPECT_EQ(info.json["contact_thickness"], 2e-3);
  EXPECT_THAT(
      info.lines,
      IsSupersetOf(
          {HasSubstr("plane through [0, 0, -1] m, normal [0, 0, 1], friction 0.5"),
           HasSubstr("sphere of radius 200 mm about [0, 0, -0.3] m, friction 0.4, 0.3 where"),
           HasSubstr("box of [1, 1, 0.1] m about [0, 0, -2] m, friction 0, moved, 2 keyframes"),
           HasSubstr("capsule of radius 10 mm from [0, 0, -0.1] to [1, 0, -0.1] m"),
           HasSubstr("from a distance of 2 mm")}));
  EXPECT_EQ(info_of(with_more("")).json["obstacles"].size(), 0u);
}

TEST(SceneInfo, WarnsOfWhatSimulateWouldRefuse) {
  const FileInfo info = info_of(with_more(""));
  EXPECT_THAT(info.warnings, Contains(HasSubstr("stretch.weft, shear, bend.weft")));
  EXPECT_THAT(info.warnings, Contains(HasSubstr("--fill FILE")));
}

TEST(SceneInfo, WritesAreasInUnitsThatRead) {
  const std::string grid = "grid: 100 mm x 100 mm";
  std::string scene = with_more("");
  scene.replace(scene.find(grid), grid.size(), "grid: 0.7 m x 1.42857142857 m");
  EXPECT_THAT(info_of(scene).lines, Contains(HasSubstr("1 m^2,")));
}

TEST(SceneInfo, RefusesAVertexThatIsNotThere) {
  const InputError error =
      input_error_of([] { info_of(with_more("pins: [{cloth: sheet, vertices: [9]}]\n")); });
  EXPECT_EQ(error.where().line, 5);
  EXPECT_EQ(error.where().field, "pins[0].vertices[0]");
}

}  // namespace
}  // namespace pliant::test
