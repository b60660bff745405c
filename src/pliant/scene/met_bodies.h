#pragma once

#include <limits>
#include <string>
#include <vector>

#include "pliant/scene/scene_system.h"

namespace pliant {

/// How near cloth is to something that it may meet.
struct MetBody {
  std::string name;   ///< of an obstacle; "" for cloth
  Location where;     ///< of the obstacle
  Touching touching;  ///< points of a convex obstacle, else pairs; those have no distance where
                      ///< they do not touch
  int first_point = std::numeric_limits<int>::max();  ///< of the system that is its own
};

/// All that cloth may meet, the nearest first.
std::vector<MetBody> met_bodies(const Scene& scene, const SceneSystem& built, const State& state);

/// Those that it touches, in words: "nearest to the cloth are itself (0.02 mm between vertex 12 and
/// face 3-4-9) and "table" (0.5 mm from vertex 7; scene.yaml:6)"; "" for none. Vertices are counted
/// from 0 over all cloth, of a mesh those of its own.
/// @param bodies    the nearest first
/// @param at_least  so many are named where their distance is known, touching or not
std::string nearest_text(const std::vector<MetBody>& bodies, size_t at_least);

}  // namespace pliant
