#pragma once

#include "pliant/contact/obstacle_shape.h"

namespace pliant {

// Tests of accepted states: they share the shapes with the code of contact, and nothing else.

/// How deep a place is in a convex body: its distance from the surface inside, below 0 outside (m).
double depth_of_place(const ObstacleShape& shape, const Eigen::Vector3d& place);

/// How deep the deepest place of a triangle is in a convex body, be it a corner or not; below 0
/// where all of it is outside (m). In closed form, but for rounding.
/// @param corners  one column each
double depth_of_triangle(const ObstacleShape& shape, const Eigen::Matrix3d& corners);

}  // namespace pliant
