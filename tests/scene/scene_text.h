#pragma once

#include <string>

#include "pliant/scene/scene.h"

#include "io/temporary_folder.h"

namespace pliant::test {

inline constexpr const char* kJersey =
    R"({"pliant": "material/1", "name": "jersey", "kind": "cloth",
 "density": 0.15, "components": {"stretch.warp": {"stiffness": {"curve": "constant", "value": 30}}}})";

/// Reads a scene beside the material jersey.json and an (empty) mesh file shirt.obj.
inline Scene read_scene_text(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("jersey.json", kJersey);
  folder.write("shirt.obj", "");
  return read_scene(folder.write("scene.yaml", text));
}

/// A scene whose line 4 is its only cloth, a grid of 3 x 3 vertices that is 100 mm wide and high;
/// `more` starts on line 5.
inline std::string with_more(const std::string& more) {
  return "pliant: scene/1\ntime: {step: 5 ms, duration: 1 s}\ncloth:\n"
         "  - {name: sheet, mesh: {grid: 100 mm x 100 mm, nodes: 3x3}, material: jersey.json}\n" +
         more;
}

/// A scene whose line 4 is its only cloth.
inline std::string with_cloth(const std::string& cloth) {
  return "pliant: scene/1\ntime: {step: 5 ms, duration: 1 s}\ncloth:\n  - " + cloth + "\n";
}

/// The same with a given mesh.
inline std::string with_mesh(const std::string& mesh) {
  return with_cloth("{name: sheet, material: jersey.json, mesh: " + mesh + "}");
}

/// A scene whose line 2 is its stepping, and line 3 what follows.
inline std::string with_time(const std::string& time, const std::string& more = "") {
  return "pliant: scene/1\ntime: " + time + "\n" + more +
         "\ncloth: [{name: sheet, mesh: {grid: 1 m x 1 m, nodes: 3x3}, material: jersey.json}]\n";
}

}  // namespace pliant::test
