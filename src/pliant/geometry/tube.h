#pragma once

#include "pliant/geometry/regular_grid.h"

namespace pliant {

/// A regular grid whose right side is sewn to its left: a tube about the z axis that stands on
/// z = 0, its front outside, without stretch. Vertex (i, j) is number j nodes_around + i; its
/// rest shape is the flat rectangle [0, circumference] x [0, length].
/// @param circumference, length  m, > 0
/// @param nodes_around  at least 3; even where diagonals alternate
/// @param nodes_along   at least 2
TriangleMesh tube(double circumference, double length, int nodes_around, int nodes_along,
                  Diagonals diagonals = Diagonals::alternating);

}  // namespace pliant
