#pragma once

#include <array>
#include <vector>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// An interior edge with its two triangles, as bending measures see it.
struct Hinge {
  std::array<int, 4> vertices{};   ///< the edge's two ends, then the opposite vertices
  std::array<int, 2> triangles{};  ///< the first has the edge in this direction
  Eigen::Vector2d rest_edge;       ///< in the rest plane of the first triangle (m)
  double height = 0;               ///< mean height of the two triangles over the edge at rest (m)
  double area = 0;                 ///< edge length times height / 3 (m^2; [T] 5.2.1)
};

/// All interior edges, in the order of the triangles.
/// @throws AssertionError for an edge with more than two triangles or with triangles that run the
/// same way along it
std::vector<Hinge> find_hinges(const TriangleMesh& mesh);

}  // namespace pliant
