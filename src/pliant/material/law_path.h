#pragma once

#include <Eigen/Core>

#include "pliant/material/component_law.h"

namespace pliant {

/// Strain and friction stress of a material point, and their derivatives with respect to all
/// parameters of a fit (those of the law first). Empty gradients: no derivatives wanted.
struct PathPoint {
  double strain = 0;
  double friction = 0;
  Eigen::VectorXd strain_gradient;
  Eigen::VectorXd friction_gradient;
  /// What the law's addends remember, one after the other; empty: they are at rest.
  Eigen::VectorXd history = {};
  Eigen::MatrixXd history_gradient = {};  ///< a row a number
};

/// Total stress at one strain of a monotone stretch.
struct PathStress {
  double stress = 0;
  double friction = 0;
  double slope = 0;                   ///< d stress / d strain along the stretch
  double friction_slope = 0;          ///< d friction / d strain along the stretch
  Eigen::VectorXd gradient;           ///< d stress / d parameters at fixed strain
  Eigen::VectorXd friction_gradient;  ///< d friction / d parameters at fixed strain
};

/// Carries a law's stress along a path of strain, one monotone stretch after the other, together
/// with the derivatives of its state (forward sensitivities).
///
/// Within a stretch every strain is evaluated from the turning point that began it, so that noise
/// of single samples does not add up; the state changes at turning points alone. What flows with
/// time goes on from row to row (`pass`).
class LawPath {
 public:
  /// @param law         its parameters are the first of the gradient
  /// @param start       state at the first turning point
  /// @param time        there (s)
  LawPath(const ComponentLaw& law, PathPoint start, double time = 0);

  /// The state at the turning point that began the present stretch.
  const PathPoint& start() const { return start_; }

  /// Stress at `strain`, reached monotonically from the last turning point.
  /// @param time  (s); without one what flows is at rest
  PathStress at(double strain, double time = kEndless) const;

  /// The stress alone, for root searches.
  double stress_at(double strain, double time = kEndless) const;

  /// Goes on from a row.
  void pass(double strain, const Eigen::VectorXd& strain_gradient, double time);

  /// Ends the stretch at `strain`, whose derivatives are `strain_gradient`.
  void turn_at(double strain, const Eigen::VectorXd& strain_gradient);

 private:
  bool with_gradients() const { return start_.strain_gradient.size() > 0; }

  /// From where an addend has gone on.
  struct Moment {
    double strain;
    Eigen::VectorXd strain_gradient;
    double time;
  };
  Moment last_moment(const Addend& addend) const;

  void add_memory(double strain, double time, PathStress& result) const;
  void advance_memory(bool of_flow, double strain, const Eigen::VectorXd& strain_gradient,
                      double time);

  ComponentLaw law_;
  PathPoint start_;
  Moment row_;  // that was passed last
};

}  // namespace pliant
