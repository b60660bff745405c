#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// What a draped sheet covers as it is seen from above, together with the disc that carries it.
struct Silhouette {
  double area = 0;            ///< m^2
  std::vector<double> radii;  ///< from the middle of the disc to the outermost point (m), at equal
                              ///< angles counter-clockwise from the x axis
};

/// Angles at which the outline of a silhouette is taken.
inline constexpr int kSilhouetteAngles = 720;

/// The silhouette of triangles along z.
/// @param positions  m, one column a point
/// @param triangles  points of each triangle, one column a triangle
/// @param disc       radius of the disc about the z axis (m)
Silhouette silhouette_of(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                         double disc);

}  // namespace pliant
