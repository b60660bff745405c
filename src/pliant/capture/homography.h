#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/capture/rigid_motion.h"

namespace pliant {

/// The homography that takes places of a plane to where they are seen, by the normalised linear
/// equations ([Hartley2003] 4.1). It is a start: lens distortion is no part of it.
/// @param plane  one column a place, at least four
/// @param seen   pixels
Eigen::Matrix3d homography(const Eigen::Matrix2Xd& plane, const Eigen::Matrix2Xd& seen);

/// The focal length that views of planes tell where pixels are square and the principal point is
/// known ([Zhang2000] Eqs. 3, 4).
/// @param homographies  from planes to pixels
/// @param principal     pixels
/// @return pixels; `otherwise` where no view is tilted enough to tell
double focal_length_of_planes(const std::vector<Eigen::Matrix3d>& homographies,
                              const Eigen::Vector2d& principal, double otherwise);

/// Where a plane is that is seen by a camera without distortion ([Zhang2000] 3.1).
/// @param homography  from the plane to pixels
/// @return the plane in camera axes, in front of it
RigidMotion pose_of_plane(const Eigen::Matrix3d& homography, double focal_length,
                          const Eigen::Vector2d& principal);

}  // namespace pliant
