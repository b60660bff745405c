#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "pliant/geometry/pose.h"
#include "pliant/scene/keyframes.h"

namespace pliant {

/// A rotation as it is stated.
struct Rotation {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< of unit length
  double angle = 0;                                 ///< rad
  bool counts_turns = true;  ///< stated as an angle, which tells 360 degrees from 0; no quaternion

  Eigen::Quaterniond quaternion() const {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
  }
};

/// The rotation vector (axis times angle, rad; world axes) that leads from one rotation to another:
/// in the angle where both turn about one axis, so that it may be more than half a turn, else the
/// shortest way.
Eigen::Vector3d turn_between(const Rotation& from, const Rotation& to);

/// Where a moved body is to be at one time.
struct MotionKeyframe {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< of the pivot, m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d turn = Eigen::Vector3d::Zero();  ///< from the keyframe before (`turn_between`)
};

/// A prescribed rigid motion, relative to where the body starts; at rest before its first and after
/// its last keyframe.
struct Motion {
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();  ///< the point of the body to turn about, world
  std::vector<double> times;                        ///< s, strictly increasing, at least one
  std::vector<MotionKeyframe> keyframes;
  Interpolation interpolation = Interpolation::linear;
};

/// The pose at a time: rotations by spherical linear interpolation.
Pose pose_at(const Motion& motion, double time);

}  // namespace pliant
