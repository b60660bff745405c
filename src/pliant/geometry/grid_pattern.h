#pragma once

#include <optional>
#include <vector>

#include "pliant/geometry/hinges.h"
#include "pliant/geometry/regular_grid.h"

namespace pliant {

/// Equal rectangles along weft and warp, all cut in one regular way.
struct GridPattern {
  double side_u = 0, side_v = 0;  ///< of a rectangle at rest (m)
  Diagonals diagonals = Diagonals::alternating;
};

/// Whether every triangle is half of a rectangle along weft and warp: a right angle between a side
/// parallel to u and one parallel to v. The rectangles may differ in size.
bool is_cut_from_rectangles(const TriangleMesh& mesh);

/// The regular pattern of a mesh, wherever the mesh came from.
/// @param hinges  of the mesh
/// @return nothing for meshes of other triangles, of unequal rectangles, or cut irregularly
std::optional<GridPattern> grid_pattern(const TriangleMesh& mesh, const std::vector<Hinge>& hinges);

}  // namespace pliant
