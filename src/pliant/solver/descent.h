#pragma once

#include <limits>

#include "pliant/solver/objective.h"
#include "pliant/solver/workspace.h"

namespace pliant {

/// How to go down an objective with few linear systems.
struct DescentOptions {
  /// At most, beside those that something in the way shortens, or that leave too much energy.
  int iterations = 3;
  int most_iterations = 20;                                      ///< at most, with those
  double most_energy = std::numeric_limits<double>::infinity();  ///< that is not too much (J)
  double motion = 3e-5;     ///< ends with an iteration that moves no point further (m)
  bool line_search = true;  ///< without it every change is taken whole
};

struct DescentSummary {
  /// With a line search: the energy fell in each iteration, or nothing would have moved further
  /// than `motion`; without one: the linear system was solved.
  bool converged = true;
  int iterations = 0;
  int linear_iterations = 0;
  double residual = 0;  ///< of the last linear system, relative; infinite where it has no solution
  Energy start, end;    ///< where it began and where it ended
};

/// Goes down an objective: each iteration solves one linear system with the convex Hessian, as
/// accurately as the workspace's solver was told, and searches along its solution for less energy.
///
/// Where a step in time begins, at the strains of its start, friction has the stiffer of its two
/// slopes; the first change is then never too long because of friction.
/// @param change  of the unknowns, a guess at the first iteration's
/// @param at      where to begin, then what was reached
DescentSummary descend(const Objective& objective, const DescentOptions& options,
                       Eigen::VectorXd change, Workspace& workspace, Configuration& at);

}  // namespace pliant
