#pragma once

#include "pliant/contact/obstacle_shape.h"
#include "pliant/geometry/pose.h"

namespace pliant {

/// An area and its derivatives.
struct SmoothedArea {
  double value = 0;              ///< m^2
  Eigen::Matrix3Xd by_position;  ///< m, one column a point
  double by_travel = 0;          ///< as the indenter moves on (m)
};

/// Area of the part of a surface that touches an indenter, smoothed so that it has derivatives
/// ([T] 4.4.2): a place counts in full up to `contact` from the indenter's surface, and the less
/// the further it is, down to nothing at `contact + fading`.
/// @param triangles  of the surface: points
/// @param indenter   where it was built
/// @param at         where it is
/// @param direction  in which it moves, of unit length
SmoothedArea touching_area(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                           const ObstacleShape& indenter, const Pose& at,
                           const Eigen::Vector3d& direction, double contact, double fading);

}  // namespace pliant
