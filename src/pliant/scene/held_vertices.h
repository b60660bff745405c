#pragma once

#include <span>
#include <vector>

#include "pliant/scene/scene.h"

namespace pliant {

/// The vertices that a scene's pins and clips hold, as numbers in their cloth's mesh, sorted.
struct HeldVertices {
  std::vector<std::vector<int>> pins;   ///< in the order of the scene's list
  std::vector<std::vector<int>> clips;  ///< in the order of the scene's list
};

/// @param cloths  in the order of the scene's list; then the nodes of its solids in theirs
/// @throws InputError as `selected_vertices`, for a vertex that two clips or a clip and a pin hold,
///         and one that two pins hold in the same direction
HeldVertices held_vertices(const Scene& scene, std::span<const ClothVertices> cloths);

}  // namespace pliant
