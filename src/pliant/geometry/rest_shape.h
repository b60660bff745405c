#pragma once

#include <vector>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// Where the rest shape of a mesh file's triangles comes from.
enum class RestShape {
  uv,     ///< texture coordinates of the corners
  shape,  ///< the shape in the file
};

/// Rest coordinates from the shape in space, u along the x axis where that is possible.
///
/// A flat mesh is laid out as a whole: u is the projection of x on its plane (of y where the plane
/// is at a right angle to x), v the direction at a right angle to u in the plane that is nearest to
/// y, then z. A mesh in z = 0 so has u = x and v = y. In a mesh that is not flat each triangle is
/// laid out in its own plane, with u the projection of x again and the corners counter-clockwise:
/// its own size and form, with weft along x wherever that is in the surface.
struct ShapeLayout {
  Eigen::Matrix2Xd rest_corners;  ///< m; as in TriangleMesh
  bool flat = false;
};
ShapeLayout lay_out_shape(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles);

/// Triangles that are joined at rest: an edge whose two triangles have the same rest coordinates
/// along it joins them, a seam does not.
/// @return the number of the panel of each triangle, counted from 0 in the order of the triangles
std::vector<int> find_panels(const TriangleMesh& mesh);

/// Area of a triangle in space (m^2).
double space_area(const TriangleMesh& mesh, int triangle);

/// Area at rest and in space (m^2).
struct AreaPair {
  double rest = 0, space = 0;

  /// How many times the larger is the smaller; infinite where one is 0.
  double mismatch() const;
};

/// Of the whole mesh; rest areas count without their signs.
AreaPair compare_areas(const TriangleMesh& mesh);

/// Of each panel of `find_panels`.
std::vector<AreaPair> compare_areas(const TriangleMesh& mesh, const std::vector<int>& panels);

}  // namespace pliant
