#pragma once

#include <Eigen/Core>

namespace pliant {

/// Unit normals of the vertices: those of the triangles around each, by their angles there
/// (Thuermer1998). A vertex without triangle area around it has the normal 0.
Eigen::Matrix3Xf vertex_normals(const Eigen::Matrix3Xf& positions,
                                const Eigen::Matrix3Xi& triangles);

/// Normals at the corners of triangles.
struct CornerNormals {
  Eigen::Matrix3Xi corners;  ///< of each triangle: the numbers of its corners' normals
  Eigen::Matrix3Xf normals;  ///< unit length; 0 where there is no area around a corner
};

/// Normals to shade a surface smoothly. The triangles around a vertex share one, but for those
/// beyond a crease: an edge over which the normal turns by more than 80 degrees, where a front
/// meets a back, or of more than two triangles.
///
/// Each is the mean of the vertex normals on the triangles around it. The vertex normals themselves
/// turn within one element over a tight fold; taken linearly over triangles they would show each
/// diagonal of the mesh as a tooth of the fold's shade.
CornerNormals corner_normals(const Eigen::Matrix3Xf& positions, const Eigen::Matrix3Xi& triangles);

}  // namespace pliant
