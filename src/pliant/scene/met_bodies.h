#pragma once

#include <string>
#include <vector>

#include "pliant/scene/scene_system.h"

namespace pliant {

/// How near cloth is to something that it may meet.
struct MetBody {
  std::string name;   ///< of an obstacle; "" for cloth
  Touching touching;  ///< points of a convex obstacle, else pairs; those have no distance where
                      ///< they do not touch
};

/// All that cloth may meet, the nearest first.
std::vector<MetBody> met_bodies(const Scene& scene, const SceneSystem& built, const State& state);

/// Those that it touches, in words: "nearest to the cloth are itself (0.02 mm)
/// and \"table\" (0.5 mm)"; "" for none.
std::string nearest_text(const std::vector<MetBody>& bodies);

}  // namespace pliant
