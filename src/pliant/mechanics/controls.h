#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/pose.h"

namespace pliant {

/// What comes from outside at one time. What is not named stays as it is: points and clips where
/// they are, forces and ends of cords as the system was built.
struct Controls {
  /// Of a point that is prescribed, or axes of it that are.
  struct Place {
    int point = 0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
    std::array<bool, 3> axes{true, true, true};
  };
  /// Of a clip that is prescribed.
  struct ClipPose {
    int clip = 0;
    Pose pose;
  };

  double time = 0;  ///< s
  std::vector<Place> places;
  std::vector<ClipPose> poses;
  /// Of bodies that are led, by the numbers that potentials have for them, from where they were
  /// built.
  std::vector<Pose> bodies;
  /// Forces (N) and ends of cords (m), one column each, by the numbers that potentials have for
  /// them.
  Eigen::Matrix3Xd vectors;

  /// Column `number`, or `otherwise` where that is not named.
  Eigen::Vector3d vector(int number, const Eigen::Vector3d& otherwise) const {
    return number >= 0 && number < vectors.cols() ? vectors.col(number).eval() : otherwise;
  }
  /// Of body `number`; where it was built if that is not named.
  Pose body(int number) const {
    return number >= 0 && number < std::ssize(bodies) ? bodies[static_cast<size_t>(number)]
                                                      : Pose{};
  }
};

/// What comes from outside at each time (s).
using Schedule = std::function<Controls(double time)>;

inline const Controls kNoControls{};

}  // namespace pliant
