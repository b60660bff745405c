#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// A force and its moment about a point.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< N m
};

/// Splits what holds a clip among its two cords: the force exactly, the moment as well as two
/// forces can, with the smallest forces that do. They have no moment about the line between their
/// points.
/// @param wrench  about `centre` (m)
/// @param points  where the cords are attached, apart (m)
/// @return the pulls of the cords (N)
std::vector<Eigen::Vector3d> cord_pulls(const Wrench& wrench, const Eigen::Vector3d& centre,
                                        const std::vector<Eigen::Vector3d>& points);

}  // namespace pliant
