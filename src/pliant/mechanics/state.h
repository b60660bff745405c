#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/pose.h"

namespace pliant {

/// Where everything is: the points of a system and the poses of its clips.
struct Configuration {
  Eigen::Matrix3Xd positions;  ///< m, one column a point
  std::vector<Pose> clips;
};

/// Everything that a system remembers from one accepted step to the next, and thus what a
/// checkpoint holds.
struct State {
  double time = 0;  ///< s
  Configuration configuration;
  Eigen::Matrix3Xd velocities;  ///< m/s
  Eigen::VectorXd history;      ///< of all potentials, segment by segment

  double last_step = 0;             ///< s; 0 before the first time step
  Eigen::Matrix3Xd last_positions;  ///< one accepted step ago, for schemes of two steps
  Eigen::Matrix3Xd last_velocities;
};

}  // namespace pliant
