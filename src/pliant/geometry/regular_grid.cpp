#include "pliant/geometry/regular_grid.h"

#include "pliant/base/assert.h"

namespace pliant {
namespace {

bool is_rising(Diagonals diagonals, int i, int j) {
  if (diagonals == Diagonals::alternating) return (i + j) % 2 == 0;
  return diagonals == Diagonals::rising;
}

}  // namespace

TriangleMesh regular_grid(double width, double height, int nodes_u, int nodes_v,
                          Diagonals diagonals) {
  PLIANT_ASSERT(width > 0 && height > 0, "a grid has a positive width and height");
  PLIANT_ASSERT(nodes_u >= 2 && nodes_v >= 2, "a grid has at least two nodes each way");
  Eigen::Matrix2Xd vertices(2, nodes_u * nodes_v);
  for (int j = 0; j < nodes_v; ++j) {
    for (int i = 0; i < nodes_u; ++i) {
      vertices.col(j * nodes_u + i) << width * i / (nodes_u - 1), height * j / (nodes_v - 1);
    }
  }
  Eigen::Matrix3Xi triangles(3, 2 * (nodes_u - 1) * (nodes_v - 1));
  Eigen::Index t = 0;
  for (int j = 0; j + 1 < nodes_v; ++j) {
    for (int i = 0; i + 1 < nodes_u; ++i) {
      const int low_left = j * nodes_u + i, low_right = low_left + 1;
      const int high_left = low_left + nodes_u, high_right = high_left + 1;
      if (is_rising(diagonals, i, j)) {
        triangles.col(t++) << low_left, low_right, high_right;
        triangles.col(t++) << low_left, high_right, high_left;
      } else {
        triangles.col(t++) << low_left, low_right, high_left;
        triangles.col(t++) << low_right, high_right, high_left;
      }
    }
  }
  return flat_mesh(vertices, triangles);
}

}  // namespace pliant
