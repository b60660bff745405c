#include "pliant/geometry/rest_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>

#include "pliant/geometry/topology.h"

namespace pliant {
namespace {

/// Distance from the common plane over the size of the mesh: above what single precision rounds.
constexpr double kFlat = 1e-5;
/// A projection shorter than this has no direction to speak of (a plane within 0.06 degrees of a
/// right angle to the axis).
constexpr double kShortest = 1e-3;

struct PlaneAxes {
  Eigen::Vector3d u, v;
};

/// The first of x and y with a projection on the plane, as a unit vector in it.
Eigen::Vector3d weft_direction(const Eigen::Vector3d& normal) {
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    const Eigen::Vector3d projection = unit - unit.dot(normal) * normal;
    if (projection.norm() > kShortest) return projection.normalized();
  }
  return Eigen::Vector3d::UnitX();  // not reached by a unit normal
}

/// The axes of a flat mesh: v is the one of the two directions that points along y, else z.
PlaneAxes flat_axes(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d u = weft_direction(normal);
  Eigen::Vector3d v = normal.cross(u);
  const double along = std::abs(v.y()) > kShortest ? v.y() : v.z();
  if (along < 0) v = -v;
  return {u, v};
}

Eigen::Vector3d area_vector(const Eigen::Matrix3Xd& positions, const Eigen::Vector3i& triangle) {
  const Eigen::Vector3d origin = positions.col(triangle[0]);
  return (positions.col(triangle[1]) - origin).cross(positions.col(triangle[2]) - origin) / 2;
}

/// The normal of the plane that all vertices of the triangles lie in; zero when there is none.
Eigen::Vector3d common_normal(const Eigen::Matrix3Xd& positions,
                              const Eigen::Matrix3Xi& triangles) {
  // The largest triangle of all tells the plane best, also where others face the other way.
  Eigen::Vector3d largest = Eigen::Vector3d::Zero();
  for (const auto& triangle : triangles.colwise()) {
    const Eigen::Vector3d area = area_vector(positions, triangle);
    if (area.squaredNorm() > largest.squaredNorm()) largest = area;
  }
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (const auto& triangle : triangles.colwise()) {
    const Eigen::Vector3d area = area_vector(positions, triangle);
    normal += area.dot(largest) < 0 ? -area : area;
  }
  if (normal.isZero(0)) return normal;
  normal.normalize();
  const Eigen::Vector3d origin = positions.col(triangles(0, 0));
  const double size = (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  for (const int vertex : triangles.reshaped()) {
    if (std::abs((positions.col(vertex) - origin).dot(normal)) > kFlat * size) {
      return Eigen::Vector3d::Zero();
    }
  }
  return normal;
}

/// Groups that grow together.
class UnionFind {
 public:
  explicit UnionFind(int count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0);
  }
  int root(int i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(int a, int b) { parents_[root(a)] = root(b); }

 private:
  std::vector<int> parents_;
};

/// The rest coordinates of a side's ends, the smaller vertex first.
Eigen::Matrix2d rest_ends(const TriangleMesh& mesh, const TriangleSide& side) {
  const Eigen::Matrix<double, 2, 3> corners = mesh.rest_triangle(side.triangle);
  Eigen::Matrix2d ends;
  ends << corners.col(side.corner), corners.col((side.corner + 1) % 3);
  if (side.from > side.to) ends.col(0).swap(ends.col(1));
  return ends;
}

}  // namespace

ShapeLayout lay_out_shape(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  ShapeLayout layout;
  layout.rest_corners.resize(2, 3 * triangles.cols());
  const Eigen::Vector3d normal = common_normal(positions, triangles);
  layout.flat = !normal.isZero(0);
  const PlaneAxes flat = layout.flat ? flat_axes(normal) : PlaneAxes{};
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    PlaneAxes axes = flat;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    if (!layout.flat) {
      const Eigen::Vector3d own = area_vector(positions, triangles.col(t)).normalized();
      axes.u = weft_direction(own);
      axes.v = own.cross(axes.u);
      origin = positions.col(triangles(0, t));
    }
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d point = positions.col(triangles(k, t)) - origin;
      layout.rest_corners.col(3 * t + k) << point.dot(axes.u), point.dot(axes.v);
    }
  }
  return layout;
}

std::vector<int> find_panels(const TriangleMesh& mesh) {
  UnionFind groups(mesh.triangle_count());
  const std::vector<TriangleSide> sides = sides_by_edge(mesh.triangles);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const TriangleSide &a = sides[i - 1], &b = sides[i];
    if (std::minmax(a.from, a.to) != std::minmax(b.from, b.to)) continue;
    if (rest_ends(mesh, a) == rest_ends(mesh, b)) groups.join(a.triangle, b.triangle);
  }
  std::vector<int> panels(mesh.triangle_count()), numbers(mesh.triangle_count(), -1);
  int count = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    int& number = numbers[groups.root(t)];
    if (number < 0) number = count++;
    panels[t] = number;
  }
  return panels;
}

double space_area(const TriangleMesh& mesh, int triangle) {
  return area_vector(mesh.positions, mesh.triangles.col(triangle)).norm();
}

double AreaPair::mismatch() const {
  const auto [low, high] = std::minmax(rest, space);
  return low > 0 ? high / low : std::numeric_limits<double>::infinity();
}

AreaPair compare_areas(const TriangleMesh& mesh) {
  const std::vector<int> one_panel(mesh.triangle_count(), 0);
  return compare_areas(mesh, one_panel).at(0);
}

std::vector<AreaPair> compare_areas(const TriangleMesh& mesh, const std::vector<int>& panels) {
  std::vector<AreaPair> areas;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    if (panels[t] >= static_cast<int>(areas.size())) areas.resize(panels[t] + 1);
    areas[panels[t]].rest += std::abs(rest_area(mesh, t));
    areas[panels[t]].space += space_area(mesh, t);
  }
  return areas;
}

}  // namespace pliant
