#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// How values pass from one keyframe to the next.
enum class Interpolation {
  linear,  ///< at constant speed
  smooth,  ///< coming to rest at every keyframe (cubic, once continuously differentiable)
};

/// The place of a time among keyframes: a keyframe, and how far on the way to the next it is.
struct KeyframePlace {
  int before = 0;
  double fraction = 0;  ///< of the way to the next, in [0, 1); 0 outside the keyframes' times
};

/// @param times  of the keyframes, strictly increasing, at least one
KeyframePlace place_among(const std::vector<double>& times, Interpolation interpolation,
                          double time);

/// A vector that changes over time; constant before its first and after its last keyframe.
struct KeyframedVector {
  std::vector<double> times;  ///< s, strictly increasing, at least one
  std::vector<Eigen::Vector3d> values;
  Interpolation interpolation = Interpolation::linear;

  static KeyframedVector constant(const Eigen::Vector3d& value) { return {{0}, {value}}; }
};

Eigen::Vector3d value_at(const KeyframedVector& vector, double time);

}  // namespace pliant
