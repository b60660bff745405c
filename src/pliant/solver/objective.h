#pragma once

#include <optional>
#include <vector>

#include "pliant/mechanics/system.h"

namespace pliant {

/// What an equilibrium or a time step minimises over the unknowns of a system: its potentials under
/// some conditions, and those that the step adds (inertia, drag).
class Objective {
 public:
  Objective(const System& system, const Conditions& under) : system_(system), under_(under) {}

  /// `potential` outlives the objective.
  void add(const Potential& potential) { of_step_.push_back(&potential); }

  const System& system() const { return system_; }
  const Conditions& conditions() const { return under_; }
  /// Counts towards a phase of the costs while it lives.
  Timed timed(double SearchCosts::*phase) const { return {under_.costs, phase}; }

  Energy energy(const Configuration& at) const;
  /// dE / d points, N; on prescribed points the force that holds them.
  Eigen::Matrix3Xd gradient(const Configuration& at) const;
  /// Energy and dE / d points.
  Energy evaluate(const Configuration& at, Eigen::Matrix3Xd& gradient) const;
  /// Energy, dE / d points and the Hessian in the unknowns.
  Energy linearize(const Configuration& at, Curvature curvature, Eigen::Matrix3Xd& gradient,
                   Hessian& hessian) const;

  /// See System.
  std::optional<Eigen::Matrix3Xd> made_way(const Eigen::Matrix3Xd& led) const;
  WayLimits way_limits(const Configuration& from, const Configuration& to, double kept) const;
  Energy advance_history(const Configuration& at, Eigen::VectorXd& history) const;

 private:
  void evaluate(const Configuration& at, Curvature curvature, Derivatives& derivatives) const;

  const System& system_;
  Conditions under_;
  std::vector<const Potential*> of_step_;
};

}  // namespace pliant
