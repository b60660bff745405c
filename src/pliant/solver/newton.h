#pragma once

#include "pliant/base/progress.h"
#include "pliant/solver/objective.h"
#include "pliant/solver/workspace.h"

namespace pliant {

struct NewtonOptions {
  double tolerance = 1e-5;  ///< largest force left on a free point (N; [T] 3.4.1: 10 uN)
  int max_iterations = 200;
  /// Exact: where the Hessian is not positive definite, its convex stand-in takes its place for the
  /// iteration.
  Curvature curvature = Curvature::exact;
  /// Steps go on with a factorised Hessian of an earlier iteration while the forces fall: for
  /// solvers that factorise slowly and solve quickly.
  bool reuse_factor = false;
  StopToken stop = {};  ///< asked before each iteration, which takes tenths of a second at most
};

struct NewtonSummary {
  bool converged = false;
  int iterations = 0;
  int factorizations = 0;
  int linear_iterations = 0;  ///< of an iterative linear solver, summed
  double residual = 0;        ///< largest force left (N)
  Energy energy;
};

/// The largest force that is not balanced: on free points, but for axes that are prescribed, and on
/// clips (N; moments of clips divided by the clip's radius).
double largest_force(const Coordinates& coordinates, const Configuration& at,
                     const Eigen::Matrix3Xd& gradient);

/// Minimises an objective by Newton's method. A Hessian that is not positive definite is replaced
/// and, if need be, shifted until it is; a line search makes sure that the energy falls. Not
/// converging is a result, not an error; what was reached is then in `at`.
/// @param at  where to begin, then the minimum
/// @throws Interrupted when a stop was requested
NewtonSummary minimize(const Objective& objective, const NewtonOptions& options,
                       Workspace& workspace, Configuration& at);

}  // namespace pliant
