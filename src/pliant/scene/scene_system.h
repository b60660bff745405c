#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/contact/obstacle_contact.h"
#include "pliant/contact/surface_contact.h"
#include "pliant/geometry/triangle_mesh.h"
#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/system.h"
#include "pliant/scene/scene.h"
#include "pliant/scene/scene_crossings.h"
#include "pliant/scene/solid_piece.h"

namespace pliant {

/// A cloth of a scene within its system.
struct ClothPiece {
  std::string name;
  TriangleMesh mesh;
  int first_point = 0;  ///< of the system: the mesh's vertex 0
  std::vector<ShownPotential> shown;
};

/// A scene made into a mechanical system. The points are the vertices of all cloths, one cloth
/// after the other, and in the same way the nodes of all solids, then the points of clips that
/// cords pull at, then the vertices of all bodies.
struct SceneSystem {
  std::unique_ptr<System> system;
  std::vector<ClothPiece> cloths;
  std::vector<SolidPiece> solids;
  Eigen::Matrix3Xi faces;         ///< of all cloths, then all solids, as points of the system
  int vertices = 0;               ///< of all cloths and solids
  std::vector<BodyPiece> bodies;  ///< of triangles
  std::vector<std::shared_ptr<ObstacleContact>> obstacle_contacts;  ///< one for each convex one
  std::shared_ptr<SurfaceContact> surface_contact;  ///< with cloth and bodies; may be null
  Schedule schedule;                                ///< what comes from outside
  State start;
  std::vector<std::string> warnings;  ///< for the user
};

/// Builds the system of a scene. Reads its meshes.
///
/// A clip's own mass is spread evenly over the vertices that it holds. Cloth that starts in another
/// shape than its rest shape has been brought there on the straight way, and its internal friction
/// with it.
/// @param filler  takes the place of components that a material does not know
/// @throws InputError for a mesh that cannot be used, a component that was not measured and is not
///         filled, a stiffness that is not positive, springs on a mesh that is no grid, cloth
///         without mass, a volume mesh or a material of a solid that cannot be used, cloth that
///         begins inside an obstacle or passing through itself
SceneSystem build_scene(const Scene& scene, const std::optional<Material>& filler);

}  // namespace pliant
