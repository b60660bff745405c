#pragma once

#include <string>
#include <vector>

#include "pliant/geometry/mesh_numbering.h"
#include "pliant/geometry/triangle_mesh.h"
#include "pliant/scene/cloth.h"

namespace pliant {

/// The mesh of a cloth, in the cloth's own coordinates.
struct ClothMesh {
  TriangleMesh mesh;
  MeshNumbering numbering;
  std::vector<std::string> warnings;  ///< what the user should know, one line each
};

/// Makes or reads the mesh that a scene asks for.
/// @throws InputError, also for a mesh that is unfit for simulation
ClothMesh make_cloth_mesh(const MeshSource& source);

/// The material of each triangle: 0 for the cloth's own, 1 + r for that of region r. Regions list
/// faces; all triangles that a polygon of a file was cut into are one face.
/// @throws InputError for a face that is not there, or listed twice
std::vector<int> material_of_triangles(const SceneCloth& cloth, const ClothMesh& mesh);

}  // namespace pliant
