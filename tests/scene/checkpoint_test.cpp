#include "pliant/scene/checkpoint.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "support/scene_simulation.h"

namespace pliant {
namespace {

/// A scene that names a file wherever one can stand.
constexpr const char* kScene =
    "pliant: scene/1\n"
    "cloth:\n"
    "  - name: sheet\n"
    "    mesh: {file: sheet.obj, unit: m, rest: shape}\n"
    "    material: cloth.json\n"
    "    regions: [{material: patch.json, faces: faces.txt}]\n"
    "pins: [{cloth: sheet, vertices: pins.txt}]\n"
    "clips: [{name: clip, cloth: sheet, vertices: clip.txt, mass: 1 g}]\n"
    "time: {step: 5 ms, duration: 1 s}\n";

TEST(SceneIdentity, ChangesWithEveryFileThatTheSceneNames) {
  const test::TemporaryFolder folder;
  const std::string cloth = material_text(test::linear_cloth(30, 10, 1e-5));
  const test::FileContents files{
      {"scene.yaml", kScene}, {"sheet.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"cloth.json", cloth},  {"patch.json", cloth},
      {"faces.txt", "0\n"},   {"pins.txt", "0\n"},
      {"clip.txt", "1 2\n"},  {"fill.json", cloth}};
  for (const auto& [name, content] : files) folder.write(name, content);
  const Scene scene = read_scene(folder.path() / "scene.yaml");
  const auto identity = [&] { return scene_identity(scene, folder.path() / "fill.json"); };

  std::set<std::string> identities{identity()};
  EXPECT_EQ(identities.count(identity()), 1u);  // of the same files the same
  EXPECT_TRUE(identities.insert(scene_identity(scene, {})).second);
  for (const auto& [name, content] : files) {
    folder.write(name, name == "scene.yaml" ? content + "name: other\n" : content + "\n");
    EXPECT_TRUE(identities.insert(identity()).second) << name;
    folder.write(name, content);
  }
}

TEST(SceneIdentity, StaysWithCommentsAndWithAnotherDuration) {
  const test::TemporaryFolder folder;
  const std::string text = "pliant: scene/1\ntime: {step: 5 ms, duration: 1 s}\n";
  Scene scene;
  scene.file = folder.write("scene.yaml", text).string();
  const std::string before = scene_identity(scene, {});
  folder.write("scene.yaml", "# longer\npliant: scene/1\ntime: {duration: 2 s, step: 5 ms}\n");
  EXPECT_EQ(scene_identity(scene, {}), before);
  folder.write("scene.yaml", "pliant: scene/1\ntime: {step: 4 ms, duration: 1 s}\n");
  EXPECT_NE(scene_identity(scene, {}), before);
}

}  // namespace
}  // namespace pliant
