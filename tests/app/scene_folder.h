#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/run_program.h"

namespace pliant::test {

/// Part of a text, and what takes its place.
using TextEdit = std::pair<std::string, std::string>;

/// @param edits  each of whose first part stands in the text exactly once
inline std::string edited_text(std::string text, const std::vector<TextEdit>& edits) {
  for (const auto& [from, to] : edits) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "nothing to edit: " << from;
    if (at == std::string::npos) continue;
    EXPECT_EQ(text.find(from, at + 1), std::string::npos) << "ambiguous edit: " << from;
    text.replace(at, from.size(), to);
  }
  return text;
}

inline void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// A scene that was simulated: its folder, and the results in `DIR/out`.
class SceneFolder : public TemporaryFolder {
 public:
  static std::filesystem::path example(const std::string& name) {
    return std::filesystem::path(PLIANT_SOURCE_DIR) / "examples" / name;
  }

  /// Copies an example, changed, with the materials it names.
  void copy_example(const std::string& name, const std::vector<TextEdit>& edits) const {
    std::string text = edited_text(content_of(example(name + ".yaml")), edits);
    replace_all(text, "../materials/", PLIANT_SOURCE_DIR "/materials/");
    replace_all(text, "material: sheets/", "material: " PLIANT_SOURCE_DIR "/examples/sheets/");
    write("scene.yaml", text);
    for (const char* material : {"cylinder-cloth.json", "rubber.json"}) {
      write(material, content_of(example(material)));
    }
  }

  std::string file(const std::string& name) const { return (path() / name).string(); }
  std::filesystem::path results(const std::string& name = "out") const { return path() / name; }

  /// `pliant simulate scene.yaml -o OUT --fill assumed-cloth.json ARGUMENTS...`
  std::vector<std::string> command(const std::vector<std::string>& arguments = {},
                                   const std::string& out = "out") const {
    std::vector<std::string> all{"simulate", file("scene.yaml"),
                                 "-o",       results(out).string(),
                                 "--fill",   example("assumed-cloth.json").string()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return all;
  }

  ProgramRun simulate(const std::vector<std::string>& arguments = {},
                      const std::string& out = "out") const {
    return run_program(command(arguments, out));
  }

  /// The results that a simulation decides alone: not what tells of time, memory and command.
  std::map<std::string, std::string> computed_files(const std::string& out = "out") const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(results(out))) {
      const std::string extension = entry.path().extension().string();
      const bool told = extension == ".json" || extension == ".html" || extension == ".bin";
      if (!entry.is_regular_file() || told) continue;
      files[entry.path().lexically_relative(results(out)).string()] = content_of(entry.path());
    }
    return files;
  }
};

/// Fails, by the names of files, where two runs differ.
inline void expect_same_files(const std::map<std::string, std::string>& expected,
                              const std::map<std::string, std::string>& found) {
  for (const auto& [name, bytes] : expected) {
    const auto other = found.find(name);
    ASSERT_NE(other, found.end()) << name << " is missing";
    EXPECT_TRUE(other->second == bytes) << name << " differs";
  }
  EXPECT_EQ(found.size(), expected.size());
}

/// A small cloth of cotton between two corners, of which one is moved; everything that a checkpoint
/// has to remember is in use: friction, hinge angles, a free clip, the step before the last.
/// @param time  of the scene
inline std::string small_scene(const std::string& time, const std::string& output) {
  return "pliant: scene/1\n"
         "name: small\n"
         "cloth:\n"
         "  - name: sheet\n"
         "    mesh: {grid: 100 mm x 100 mm, nodes: 9x9}\n"
         "    material: " PLIANT_SOURCE_DIR
         "/materials/cotton.json\n"
         "    place: {rotate: {axis: [1, 0, 0], angle: 80 deg}}\n"
         "pins:\n"
         "  - {cloth: sheet, corners: [top-left]}\n"
         "  - cloth: sheet\n"
         "    corners: [top-right]\n"
         "    motion: {keyframes: [{time: 0 s}, {time: 100 ms, translate: [-0.02, 0.01, 0]}]}\n"
         "clips:\n"
         "  - name: weight\n"
         "    cloth: sheet\n"
         "    within: {box: {low: [0.03, 0, 0], high: [0.07, 0, 0]}}\n"
         "    mass: 2 g\n"
         "    free: true\n"
         "    cords: [{at: [0.05, 0, 0], force: {keyframes: [{time: 0 s, value: [0, 0, 0]},\n"
         "            {time: 100 ms, value: [0, 0.01, -0.02]}]}}]\n"
         "time: " +
         time + "\noutput: " + output + "\n";
}

}  // namespace pliant::test
