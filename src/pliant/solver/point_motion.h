#pragma once

#include "pliant/mechanics/coordinates.h"

namespace pliant {

/// First of the two block rows of a free clip, that of its translation.
int clip_row(const Coordinates& coordinates, int clip);

/// Largest distance of a clip's points from its origin (m).
double clip_radius(const Coordinates& coordinates, const Configuration& at, int clip);

/// How the points move with the unknowns, to first order: one column a point, zero for those that
/// are moved from outside.
/// @param rates  change of each unknown
Eigen::Matrix3Xd point_motion(const Coordinates& coordinates, const Configuration& at,
                              const Eigen::VectorXd& rates);

}  // namespace pliant
