#pragma once

#include <vector>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// A connected piece of one panel of a mesh, laid out in the rest plane.
struct RestPatch {
  TriangleMesh mesh;        ///< flat, with vertices of its own
  std::vector<int> depths;  ///< of each vertex: edges between it and the rim of the piece
};

/// A piece around the vertex that is farthest from any rim or seam, grown over neighbours.
/// @param mesh           with at least one triangle
/// @param max_triangles  where to stop, >= 1; a smaller panel is taken whole
RestPatch rest_patch(const TriangleMesh& mesh, int max_triangles);

}  // namespace pliant
