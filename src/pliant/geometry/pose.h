#pragma once

#include <Eigen/Geometry>

namespace pliant {

/// Where a rigid body is: x = rotation * local + translation.
struct Pose {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< of unit length
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         ///< m

  Eigen::Vector3d apply(const Eigen::Vector3d& local) const {
    return rotation * local + translation;
  }
  /// The place in the body.
  Eigen::Vector3d local(const Eigen::Vector3d& world) const {
    return rotation.conjugate() * (world - translation);
  }
};

}  // namespace pliant
