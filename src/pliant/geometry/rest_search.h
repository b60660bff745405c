#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// A point of the rest plane as seen from a triangle of a mesh.
struct RestPoint {
  int triangle = 0;
  Eigen::Vector3d weights;  ///< barycentric, sum 1; one is negative outside the triangle
  double outside = 0;       ///< distance from the triangle (m)
};

/// Finds points of the rest plane in the triangles of a mesh, with a uniform grid over them.
class RestSearch {
 public:
  /// @param mesh  whose triangles do not overlap at rest and run counter-clockwise; it must outlive
  ///              the search
  explicit RestSearch(const TriangleMesh& mesh);

  /// The point in the triangle that holds it, or in the nearest one.
  RestPoint find(const Eigen::Vector2d& point) const;

 private:
  Eigen::Array2i cell_of(const Eigen::Vector2d& point) const;
  const std::vector<int>& triangles_in(const Eigen::Array2i& cell) const;
  int nearest_triangle(const Eigen::Vector2d& point) const;

  const TriangleMesh* mesh_;
  Eigen::Vector2d low_;
  double cell_size_ = 0;
  Eigen::Array2i cells_;
  std::vector<std::vector<int>> triangles_;  // whose bounding box meets a cell, row by row
};

/// The points of a mesh's rest plane with the values of its vertices, linear in each triangle and
/// continued beyond its rim.
/// @param values  one column a vertex of the mesh
/// @return one column a point
Eigen::Matrix3Xd interpolated(const TriangleMesh& mesh, const std::vector<RestPoint>& points,
                              const Eigen::Matrix3Xd& values);

}  // namespace pliant
