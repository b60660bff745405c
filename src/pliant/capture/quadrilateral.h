#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// Corners in a picture, one after the other, either way round.
using Quadrilateral = Eigen::Matrix<double, 2, 4>;

/// Whether a place lies in it with a margin around.
bool is_within(const Quadrilateral& corners, const Eigen::Vector2d& place, double margin);

/// Whole pixels that lie in it with a margin around, in rows along its first side: evenly from side
/// to side, at most `step` apart.
std::vector<Eigen::Vector2d> places_within(const Quadrilateral& corners, int step, int margin);

}  // namespace pliant
