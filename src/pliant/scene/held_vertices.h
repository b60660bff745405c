#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "pliant/scene/scene.h"

namespace pliant {

/// The vertices that a scene's pins and clips hold, as numbers in their cloth's mesh, sorted.
struct HeldVertices {
  std::vector<std::vector<int>> pins;   ///< in the order of the scene's list
  std::vector<std::vector<int>> clips;  ///< in the order of the scene's list
};

/// @param positions  of each cloth's mesh in the cloth's own coordinates (m), in the order of the
///                   scene's list
/// @throws InputError for a vertex that is not there, a pin or clip that holds none, a vertex that
///         two clips or a clip and a pin hold, and one that two pins hold in the same direction
HeldVertices held_vertices(const Scene& scene, std::span<const Eigen::Matrix3Xd> positions);

}  // namespace pliant
