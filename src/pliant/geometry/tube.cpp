#include "pliant/geometry/tube.h"

#include <cmath>
#include <numbers>

#include "pliant/base/assert.h"

namespace pliant {

TriangleMesh tube(double circumference, double length, int nodes_around, int nodes_along,
                  Diagonals diagonals) {
  PLIANT_ASSERT(nodes_around >= 3, "a tube has at least three nodes around");
  PLIANT_ASSERT(nodes_around % 2 == 0 || diagonals != Diagonals::alternating,
                "diagonals alternate around a tube of an even number of nodes");
  const TriangleMesh grid =
      regular_grid(circumference, length, nodes_around + 1, nodes_along, diagonals);
  // The edges around are the sides of a regular polygon, as long as they are at rest.
  const double half_turn = std::numbers::pi / nodes_around;
  const double radius = circumference / (2 * nodes_around * std::sin(half_turn));

  TriangleMesh mesh;
  mesh.rest_corners = grid.rest_corners;
  mesh.positions.resize(3, nodes_around * nodes_along);
  const auto sewn = [&](int vertex) {
    const int i = vertex % (nodes_around + 1), j = vertex / (nodes_around + 1);
    return j * nodes_around + i % nodes_around;
  };
  for (int vertex = 0; vertex < grid.vertex_count(); ++vertex) {
    const double angle = 2 * half_turn * (vertex % (nodes_around + 1) % nodes_around);
    mesh.positions.col(sewn(vertex)) << radius * std::cos(angle), radius * std::sin(angle),
        grid.positions(1, vertex);
  }
  mesh.triangles = grid.triangles.unaryExpr(sewn);
  return mesh;
}

}  // namespace pliant
