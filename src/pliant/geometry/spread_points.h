#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// Points of a set that lie far from each other: the one nearest to the middle, then ever again the
/// one that is farthest from those that were taken; of several the first.
/// @param count  at most as many as there are
/// @return their places in the set, in the order in which they were taken
std::vector<int> spread_points(const Eigen::Matrix3Xd& points, int count);

/// The middles of the cells of a grid over a box, x first.
/// @param cells  along each axis, at least 1
std::vector<Eigen::Vector3d> middles_of_cells(const Eigen::Vector3d& low,
                                              const Eigen::Vector3d& size,
                                              const Eigen::Vector3i& cells);

/// The mean distance of places to their nearest neighbour; 0 of a single one.
double spacing_of_neighbours(const std::vector<Eigen::Vector3d>& places);

}  // namespace pliant
