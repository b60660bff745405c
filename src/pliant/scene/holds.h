#pragma once

#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/errors.h"
#include "pliant/io/fields.h"
#include "pliant/scene/cloth.h"
#include "pliant/scene/keyframes.h"
#include "pliant/scene/motion.h"
#include "pliant/scene/solid.h"
#include "pliant/scene/vertex_selection.h"

namespace pliant {

/// Vertices that are held where they start, or moved along.
struct ScenePin {
  int piece = 0;  ///< its place among the scene's cloths and then its solids
  VertexSelection vertices;
  std::array<bool, 3> directions{true, true, true};  ///< world axes in which they are held
  std::optional<Motion> motion;                      ///< held still when absent
  Location where;
};

/// An elastic thread from a clip to a point in space, slack while it is shorter than its length.
struct CordSpring {
  KeyframedVector end;   ///< m, world
  double length = 0;     ///< m, without force
  double stiffness = 0;  ///< N/m
};

/// What pulls at one point of a clip: a force, or a cord.
struct SceneCord {
  std::optional<int> vertex;                     ///< of the cloth; else `at`
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in the cloth's own coordinates, m
  std::optional<KeyframedVector> force;          ///< N, world; else `spring`
  CordSpring spring;
  Location where;
};

/// A rigid body that vertices are clamped to.
struct SceneClip {
  std::string name;
  int cloth = 0;  ///< its place in the scene's list
  VertexSelection vertices;
  double mass = 0;               ///< kg, of the clip itself
  bool free = false;             ///< moves as forces have it; else held, or moved by `motion`
  std::optional<Motion> motion;  ///< held still when absent and not `free`
  std::vector<SceneCord> cords;  ///< of free clips
  Location where;
};

/// Reads an element of the list `pins`.
/// @throws InputError
ScenePin read_scene_pin(const Value& value, std::span<const SceneCloth> cloths,
                        std::span<const SceneSolid> solids);

/// Reads an element of the list `clips`.
/// @param taken  names of the clips so far; gets the new one
/// @throws InputError
SceneClip read_scene_clip(const Value& value, std::span<const SceneCloth> cloths,
                          std::set<std::string>& taken);

}  // namespace pliant
