#pragma once

#include <Eigen/Core>

namespace pliant {

/// A place on a surface of triangles.
struct SurfacePlace {
  Eigen::Vector3i nodes{0, 0, 0};                    ///< of its triangle
  Eigen::Vector3d shares = Eigen::Vector3d::Zero();  ///< of these, each in [0, 1], of sum 1
  double distance = 0;                               ///< from the place that was asked for (m)

  Eigen::Vector3d at(const Eigen::Matrix3Xd& positions) const {
    return positions(Eigen::all, nodes) * shares;
  }
};

/// The place on a surface that is nearest to one in space; of several the first.
/// @param triangles  at least one
SurfacePlace nearest_on_surface(const Eigen::Matrix3Xd& positions,
                                const Eigen::Matrix3Xi& triangles, const Eigen::Vector3d& place);

}  // namespace pliant
