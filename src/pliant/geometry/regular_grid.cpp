#include "pliant/geometry/regular_grid.h"

#include <algorithm>
#include <functional>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

bool is_rising(Diagonals diagonals, int i, int j) {
  if (diagonals == Diagonals::alternating) return (i + j) % 2 == 0;
  return diagonals == Diagonals::rising;
}

std::vector<double> even_lines(double side, int nodes) {
  std::vector<double> lines;
  for (int i = 0; i < nodes; ++i) lines.push_back(side * i / (nodes - 1));
  return lines;
}

bool increases(const std::vector<double>& lines) {
  return lines.size() >= 2 &&
         std::ranges::adjacent_find(lines, std::greater_equal()) == lines.end();
}

}  // namespace

TriangleMesh regular_grid(double width, double height, int nodes_u, int nodes_v,
                          Diagonals diagonals) {
  PLIANT_ASSERT(width > 0 && height > 0, "a grid has a positive width and height");
  PLIANT_ASSERT(nodes_u >= 2 && nodes_v >= 2, "a grid has at least two nodes each way");
  return grid_of_lines(even_lines(width, nodes_u), even_lines(height, nodes_v), diagonals);
}

TriangleMesh grid_of_lines(const std::vector<double>& lines_u, const std::vector<double>& lines_v,
                           Diagonals diagonals) {
  PLIANT_ASSERT(increases(lines_u) && increases(lines_v), "a grid has increasing lines");
  const auto nodes_u = static_cast<int>(lines_u.size()), nodes_v = static_cast<int>(lines_v.size());
  Eigen::Matrix2Xd vertices(2, nodes_u * nodes_v);
  Eigen::Index vertex = 0;
  for (const double v : lines_v) {
    for (const double u : lines_u) vertices.col(vertex++) << u, v;
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
