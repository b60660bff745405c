#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/scene/cloth_mesh.h"
#include "pliant/scene/scene.h"

namespace pliant {

/// A material of a cloth with the triangles made of it.
struct ClothRegion {
  Material material;
  Location where;
  std::vector<int> triangles;
};

/// Sorts the triangles of a cloth by material, as a simulation takes that.
/// @param filler    takes the place of components that a material does not know
/// @param warnings  gets what is assumed or not used
/// @throws InputError for a component that was not measured and is not filled, a stiffness that is
///         not positive, springs on a mesh that is no grid, cloth without mass
std::vector<ClothRegion> cloth_regions(const SceneCloth& cloth, const ClothMesh& mesh,
                                       const Scene& scene, const std::optional<Material>& filler,
                                       std::vector<std::string>& warnings);

}  // namespace pliant
