#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/quantity.h"
#include "pliant/io/document.h"
#include "pliant/mechanics/air_drag.h"
#include "pliant/scene/cloth.h"
#include "pliant/scene/frame_output.h"
#include "pliant/scene/holds.h"
#include "pliant/scene/obstacles.h"
#include "pliant/scene/solid.h"
#include "pliant/scene/stepping.h"

namespace pliant {

/// Content of a scene/1 file (docs/formats/scene.md): what is simulated, how, and what is written.
struct Scene {
  std::string file;
  std::string name;
  std::map<std::string, std::string> info;
  std::vector<SceneCloth> cloth;  ///< at least one, or a solid
  std::vector<SceneSolid> solids;
  std::vector<ScenePin> pins;
  std::vector<SceneClip> clips;
  std::vector<SceneObstacle> obstacles;
  SceneContact contact;
  Eigen::Vector3d gravity{0, 0, -kStandardGravity};  ///< m/s^2
  std::optional<Air> air;                            ///< vacuum when absent
  std::optional<double> damping_fraction;            ///< in place of the materials' own
  Stepping time;
  FrameOutput output;
};

/// Reads a scene/1 file and the materials that it names. Meshes are not read: what depends on them
/// (numbers of vertices and faces) is judged where the scene is built.
/// @throws InputError
Scene read_scene(const std::filesystem::path& path);

/// The scene that a document describes.
Scene scene_of(const Document& document);

}  // namespace pliant
