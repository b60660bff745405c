#include "pliant/geometry/hinges.h"

#include <map>
#include <utility>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

// A triangle's side from corner `corner` to the next.
struct Side {
  int triangle = 0;
  int corner = 0;
};

int vertex(const TriangleMesh& mesh, const Side& side, int offset) {
  return mesh.triangles((side.corner + offset) % 3, side.triangle);
}

Eigen::Vector2d rest_edge(const TriangleMesh& mesh, const Side& side) {
  const Eigen::Matrix<double, 2, 3> corners = mesh.rest_triangle(side.triangle);
  return corners.col((side.corner + 1) % 3) - corners.col(side.corner);
}

double height_over(const TriangleMesh& mesh, const Side& side) {
  return 2 * rest_area(mesh, side.triangle) / rest_edge(mesh, side).norm();
}

Hinge make_hinge(const TriangleMesh& mesh, const Side& first, const Side& second) {
  Hinge hinge;
  hinge.vertices = {vertex(mesh, first, 0), vertex(mesh, first, 1), vertex(mesh, first, 2),
                    vertex(mesh, second, 2)};
  hinge.triangles = {first.triangle, second.triangle};
  hinge.rest_edge = rest_edge(mesh, first);
  hinge.height = (height_over(mesh, first) + height_over(mesh, second)) / 2;
  hinge.area = hinge.rest_edge.norm() * hinge.height / 3;
  return hinge;
}

}  // namespace

std::vector<Hinge> find_hinges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, Side> sides;  // by directed edge
  std::vector<Hinge> hinges;
  for (int i = 0; i < 3 * mesh.triangle_count(); ++i) {
    const Side side{i / 3, i % 3};
    const int from = vertex(mesh, side, 0), to = vertex(mesh, side, 1);
    const bool fresh = sides.emplace(std::pair(from, to), side).second;
    PLIANT_ASSERT(fresh, "two triangles run the same way along an edge");
    const auto opposite = sides.find({to, from});
    if (opposite != sides.end()) hinges.push_back(make_hinge(mesh, opposite->second, side));
  }
  return hinges;
}

}  // namespace pliant
