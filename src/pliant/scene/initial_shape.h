#pragma once

#include <Eigen/Core>

#include "pliant/base/errors.h"

namespace pliant {

/// Directions in a cloth's rest plane that a cylinder's axis may have.
enum class CylinderAxis {
  u,         ///< weft: the cloth is curved along warp
  v,         ///< warp: the cloth is curved along weft
  diagonal,  ///< (1, 1)
};

/// A flat cloth rolled onto a cylinder without stretching it; its rest shape stays flat.
///
/// The line through (0, 0) along the axis stays where it is, and the cloth's plane there is the
/// cylinder's tangent plane. With a pitch it is rolled up to the involute of a circle, whose turns
/// are equally far apart: its radius of curvature grows with the angle from that line.
struct RolledShape {
  double radius = 0;  ///< m, > 0; with a pitch, along the line that stays
  CylinderAxis axis = CylinderAxis::u;
  bool towards_back = false;  ///< the cylinder lies on the side of -z, else on that of +z
  double pitch = 0;           ///< distance of each turn from the next, m, >= 0
  Location where;
};

/// Where points of the flat cloth's space come to lie (m): those at a height over its plane keep
/// it.
Eigen::Matrix3Xd rolled(const RolledShape& shape, const Eigen::Matrix3Xd& points);

/// @throws InputError where points are not in the plane z = 0, or lie within the innermost turn
void require_rollable(const RolledShape& shape, const Eigen::Matrix3Xd& points);

}  // namespace pliant
