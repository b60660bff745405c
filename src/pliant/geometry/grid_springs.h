#pragma once

#include <array>
#include <vector>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// A spring between two vertices of a grid.
struct GridSpring {
  std::array<int, 2> vertices{};
  double rest_length = 0;  ///< in the rest plane (m)
  double area = 0;         ///< of the sheet that it stands for (m^2); 0 for bending
};

/// The springs of a grid of rectangles ([T] Eq. 3.1).
///
/// Along u, along v and on the diagonals the areas add up to that of the sheet. Springs of the
/// second ring, for bending, join the outer two of three vertices in a row.
struct GridSprings {
  std::vector<GridSpring> along_u;   ///< structural, weft
  std::vector<GridSpring> along_v;   ///< structural, warp
  std::vector<GridSpring> diagonal;  ///< both diagonals of each rectangle
  std::vector<GridSpring> bending_u, bending_v, bending_diagonal;
};

/// @param mesh  cut from rectangles along weft and warp (`is_cut_from_rectangles`), each along one
///              of its diagonals
GridSprings grid_springs(const TriangleMesh& mesh);

}  // namespace pliant
