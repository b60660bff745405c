#pragma once

#include <map>
#include <string>

#include "pliant/material/material_file.h"
#include "pliant/scene/simulation.h"

#include "io/temporary_folder.h"
#include "support/cloth_sheet.h"

namespace pliant::test {

/// Contents of files by their names.
using FileContents = std::map<std::string, std::string>;

/// The simulation of a scene whose files stand beside it.
inline Simulation simulation_of(const std::string& scene, const FileContents& files) {
  const TemporaryFolder folder;
  for (const auto& [name, content] : files) folder.write(name, content);
  return Simulation(read_scene(folder.write("scene.yaml", scene)), {});
}

/// A scene whose cloth is of `cloth.json`.
inline Simulation simulation_of(const std::string& scene, const Material& cloth) {
  return simulation_of(scene, {{"cloth.json", material_text(cloth)}});
}

inline void take_steps(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.advance();
}

/// How far each vertex has come from where it started (m).
inline Eigen::Matrix3Xd way(const Simulation& simulation) {
  return simulation.now().state.configuration.positions -
         simulation.built().start.configuration.positions;
}

/// A strip whose lower edge is pinned and whose upper edge is held by a free clip. The mesh and its
/// masses are symmetric, so that the strip has one degree of freedom in its plane: its length,
/// along y. Strain and stress are those of StVK ([T] Eq. 3.3), the same everywhere.
struct ClampedStrip {
  static constexpr double kWidth = 0.04, kLength = 0.1;  // m
  static constexpr double kStiffness = 30;               // N/m
  static constexpr double kDensity = 0.2;                // kg/m^2
  static constexpr double kClipMass = 0.01;              // kg
  static constexpr int kTop = 4;                         // a vertex of the upper edge

  /// What moves with the upper edge: the clip and half of the cloth (kg).
  static constexpr double kMovingMass = kClipMass + kDensity * kWidth * kLength / 2;

  static Material material() { return linear_cloth(kStiffness, 10, 1e-5); }

  /// @param cloth, clip  further keys of the cloth and of the clip, each after a comma
  /// @param more         further keys of the scene, with its `time`
  static std::string scene(const std::string& more, const std::string& clip = "",
                           const std::string& cloth = "") {
    return "pliant: scene/1\n"
           "cloth:\n"
           "  - {name: strip, mesh: {grid: 40 mm x 100 mm, nodes: 3x2}, material: cloth.json" +
           cloth +
           "}\n"
           "pins: [{cloth: strip, edges: [bottom]}]\n"
           "clips: [{name: weight, cloth: strip, edges: [top], mass: 10 g, free: true" +
           clip + "}]\n" + more;
  }

  static double length(const Simulation& simulation) {
    return simulation.now().state.configuration.positions(1, kTop);
  }
  static double strain(double length) { return (length * length / (kLength * kLength) - 1) / 2; }
  /// Force with which a strip under `stress` (N/m) pulls at the clip (N): area * stress *
  /// d strain / d length.
  static double pull(double length, double stress) { return kWidth * stress * length / kLength; }
  static double elastic_pull(double length) { return pull(length, kStiffness * strain(length)); }
};

}  // namespace pliant::test
