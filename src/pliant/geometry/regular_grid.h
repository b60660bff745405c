#pragma once

#include <vector>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// Which way the squares of a grid are cut.
enum class Diagonals {
  alternating,  ///< like a chessboard: neighbouring squares the other way
  rising,       ///< all from lower left to upper right
  falling,      ///< all from upper left to lower right
};

/// A rectangle [0, width] x [0, height] at rest with nodes_u x nodes_v vertices; vertex (i, j) is
/// number j nodes_u + i.
/// @param width, height  m, > 0
/// @param nodes_u, nodes_v  at least 2
TriangleMesh regular_grid(double width, double height, int nodes_u, int nodes_v,
                          Diagonals diagonals = Diagonals::alternating);

/// The same of lines at any distances: vertex (i, j) is at (u_i, v_j).
/// @param lines_u, lines_v  rest coordinates (m), at least two each, increasing
TriangleMesh grid_of_lines(const std::vector<double>& lines_u, const std::vector<double>& lines_v,
                           Diagonals diagonals = Diagonals::alternating);

}  // namespace pliant
