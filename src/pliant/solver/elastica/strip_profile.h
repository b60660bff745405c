#pragma once

#include <Eigen/Core>

#include "pliant/solver/elastica/gauss_line.h"

namespace pliant {

/// A point of a strip's profile.
struct StripPoint {
  Eigen::Vector2d position;  ///< m
  Eigen::Vector2d tangent;   ///< unit vector, away from the clamp
  double curvature = 0;      ///< 1/m, positive where the profile turns left

  /// Across the profile, to its left.
  Eigen::Vector2d normal() const { return {-tangent.y(), tangent.x()}; }
};

/// The line that a bent strip forms, from its clamp at the origin. Places are distances from the
/// clamp along the strip (m). Refers to the line of the strip, which outlives it.
class StripProfile {
 public:
  /// @param clamp_angle              direction at the clamp against +x (rad)
  /// @param curvature                at the points of the line (1/m)
  /// @param curvature_by_parameter   a column each; empty for no derivatives
  StripProfile(const GaussLine& line, double clamp_angle, const Eigen::VectorXd& curvature,
               const Eigen::MatrixXd& curvature_by_parameter);

  StripPoint at(double place) const;
  /// d position at `place` / d parameters: 2 x parameters.
  Eigen::MatrixXd position_by_parameter(double place) const;
  /// The place that is nearest to `target` among those that a search from `guess` finds.
  double nearest(const Eigen::Vector2d& target, double guess) const;

 private:
  const GaussLine& line_;
  double clamp_angle_ = 0;
  Eigen::VectorXd cosine_, sine_;
  Eigen::Matrix3Xd grown_;   // by the line's points: what direction, x and y grow with
  Eigen::Matrix3Xd before_;  // each element: direction against the clamp, x and y at its start
  Eigen::MatrixXd turn_by_parameter_;  // of the direction
};

}  // namespace pliant
