#pragma once

#include <Eigen/Core>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// Standard deviations of a mesh's vertices by those of measured points: those of the nearest
/// point, since the errors of points so near are alike; beyond the points they grow.
/// @param places     2 x points, rest coordinates (m)
/// @param of_points  3 x points (m)
/// @param leverages  of the vertices, as of MovedPlace
/// @param reach      of the nearest point (m); where none is, the largest deviations
/// @return 3 x vertices (m)
Eigen::Matrix3Xd vertex_deviations(const TriangleMesh& mesh, const Eigen::Matrix2Xd& places,
                                   const Eigen::Matrix3Xd& of_points,
                                   const Eigen::VectorXd& leverages, double reach);

}  // namespace pliant
