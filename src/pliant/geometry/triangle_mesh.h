#pragma once

#include <Eigen/Core>

namespace pliant {

/// A triangulated sheet: its vertices in space, and its rest shape in the plane of weft (u) and
/// warp (v).
///
/// Rest coordinates belong to the corners of triangles, not to vertices: panels that are sewn
/// together share vertices in space and not in the plane.
struct TriangleMesh {
  Eigen::Matrix3Xd positions;  ///< m, one column a vertex
  Eigen::Matrix3Xi triangles;  ///< vertices of each triangle, counter-clockwise in the rest plane
  Eigen::Matrix2Xd rest_corners;  ///< m; corner k of triangle t is column 3 t + k

  int vertex_count() const { return static_cast<int>(positions.cols()); }
  int triangle_count() const { return static_cast<int>(triangles.cols()); }

  /// Rest coordinates of a triangle's corners.
  Eigen::Matrix<double, 2, 3> rest_triangle(int triangle) const {
    return rest_corners.middleCols<3>(3 * triangle);
  }
};

/// Signed rest area of a triangle (m^2); negative when its corners run clockwise.
double rest_area(const TriangleMesh& mesh, int triangle);

/// Area of the whole sheet at rest (m^2).
double rest_area(const TriangleMesh& mesh);

/// A flat mesh whose rest shape is its shape: z = 0, u = x, v = y.
TriangleMesh flat_mesh(const Eigen::Matrix2Xd& vertices, const Eigen::Matrix3Xi& triangles);

}  // namespace pliant
