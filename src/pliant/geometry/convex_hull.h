#pragma once

#include <Eigen/Core>

namespace pliant {

/// The corners of the convex hull of points in a plane, counter-clockwise, none on a line between
/// its neighbours: two for points on one line, one for a single point.
/// @param points  at least one, one column a point
Eigen::Matrix2Xd convex_hull(const Eigen::Matrix2Xd& points);

/// Distance of a point from a convex polygon; 0 within it.
/// @param corners  counter-clockwise; two are a segment, one is a point
double distance_from_convex(const Eigen::Matrix2Xd& corners, const Eigen::Vector2d& point);

}  // namespace pliant
