#pragma once

#include "pliant/solver/objective.h"
#include "pliant/solver/workspace.h"

namespace pliant {

/// How to go down an objective with few linear systems.
struct DescentOptions {
  int iterations = 3;       ///< at most
  double motion = 3e-5;     ///< ends with an iteration that moves no point further (m)
  bool line_search = true;  ///< without it every change is taken whole
};

struct DescentSummary {
  bool converged =
      true;  ///< every linear system was solved, and the energy fell where it was asked
  int iterations = 0;
  int linear_iterations = 0;
  double residual = 0;  ///< of the last linear system, relative; infinite where it has no solution
  Energy start;         ///< where it began
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
