#include "pliant/geometry/grid_springs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "pliant/base/assert.h"
#include "pliant/geometry/grid_pattern.h"

namespace pliant {
namespace {

// A triangle as half of a rectangle: the corner of the right angle, and where its sides lead.
struct HalfRectangle {
  int corner = 0, to_u = 0, to_v = 0;  // vertices
  Eigen::Vector2d side;                // (along u, along v), with their signs (m)

  HalfRectangle(const TriangleMesh& mesh, int triangle) {
    const Eigen::Matrix<double, 2, 3> x = mesh.rest_triangle(triangle);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d first = x.col((k + 1) % 3) - x.col(k);
      const Eigen::Vector2d second = x.col((k + 2) % 3) - x.col(k);
      const bool first_along_u = std::abs(first.x()) > std::abs(first.y());
      const bool second_along_u = std::abs(second.x()) > std::abs(second.y());
      const double slant = std::abs(first.dot(second)) / (first.norm() * second.norm());
      if (slant > 0.01 || first_along_u == second_along_u) continue;
      const int u = first_along_u ? 1 : 2;
      corner = mesh.triangles(k, triangle);
      to_u = mesh.triangles((k + u) % 3, triangle);
      to_v = mesh.triangles((k + 3 - u) % 3, triangle);
      side = first_along_u ? Eigen::Vector2d(first.x(), second.y())
                           : Eigen::Vector2d(second.x(), first.y());
    }
  }
};

using Pair = std::pair<int, int>;
using Springs = std::map<Pair, GridSpring>;

void add(int a, int b, double length, double area, Springs& springs) {
  GridSpring& spring = springs[std::minmax(a, b)];
  spring.vertices = {std::min(a, b), std::max(a, b)};
  spring.rest_length = length;
  spring.area += area;
}

std::vector<GridSpring> list(const Springs& springs) {
  std::vector<GridSpring> result;
  for (const auto& [pair, spring] : springs) result.push_back(spring);
  return result;
}

// The next vertex along an axis or across a rectangle, and the way there in the rest plane.
struct Neighbour {
  int vertex = -1;
  Eigen::Vector2d way = Eigen::Vector2d::Zero();  // m
};
using Neighbours = std::map<int, Neighbour>;

Neighbour next(const Neighbours& along, int vertex) {
  const auto found = along.find(vertex);
  return found == along.end() ? Neighbour{} : found->second;
}

std::vector<GridSpring> second_ring(const Neighbours& along) {
  std::vector<GridSpring> springs;
  for (const auto& [vertex, first] : along) {
    const Neighbour second = next(along, first.vertex);
    if (second.vertex < 0) continue;
    springs.push_back({{vertex, second.vertex}, (first.way + second.way).norm(), 0});
  }
  return springs;
}

// The vertex across each rectangle, by two steps.
Neighbours across(const Neighbours& first, const Neighbours& second) {
  Neighbours result;
  for (const auto& [vertex, side] : first) {
    const Neighbour end = next(second, side.vertex);
    if (end.vertex >= 0) result[vertex] = {end.vertex, side.way + end.way};
  }
  return result;
}

}  // namespace

GridSprings grid_springs(const TriangleMesh& mesh) {
  PLIANT_ASSERT(is_cut_from_rectangles(mesh), "springs need a grid of rectangles");
  Springs along_u, along_v, diagonal;
  Neighbours right, up, down;
  std::map<Pair, int> across_diagonal;  // the right-angled corner of the first half
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const HalfRectangle half(mesh, t);
    const double area = rest_area(mesh, t), width = std::abs(half.side.x()),
                 height = std::abs(half.side.y());
    add(half.corner, half.to_u, width, area, along_u);
    add(half.corner, half.to_v, height, area, along_v);
    add(half.to_u, half.to_v, half.side.norm(), area / 2, diagonal);
    const auto [entry, is_first] =
        across_diagonal.try_emplace(std::minmax(half.to_u, half.to_v), half.corner);
    if (!is_first) add(entry->second, half.corner, half.side.norm(), area, diagonal);

    const bool rightwards = half.side.x() > 0, upwards = half.side.y() > 0;
    const Eigen::Vector2d along(width, 0), up_by(0, height);
    right[rightwards ? half.corner : half.to_u] = {rightwards ? half.to_u : half.corner, along};
    up[upwards ? half.corner : half.to_v] = {upwards ? half.to_v : half.corner, up_by};
    down[upwards ? half.to_v : half.corner] = {upwards ? half.corner : half.to_v, -up_by};
  }
  GridSprings springs{list(along_u),      list(along_v),   list(diagonal),
                      second_ring(right), second_ring(up), second_ring(across(right, up))};
  const auto falling = second_ring(across(right, down));
  springs.bending_diagonal.insert(springs.bending_diagonal.end(), falling.begin(), falling.end());
  return springs;
}

}  // namespace pliant
