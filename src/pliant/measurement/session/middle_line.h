#pragma once

#include <vector>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// The vertices within a third of an edge of the line through the middle of a sheet at rest, in
/// the order of the mesh; where there are none, as on a grid with an odd number of cells, those of
/// the line next to it. Never empty.
/// @param along  0: the line runs along weft, 1: along warp
std::vector<int> middle_line(const TriangleMesh& rest, int along);

}  // namespace pliant
