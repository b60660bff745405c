#pragma once

#include <functional>
#include <limits>

#include <Eigen/Core>

#include "pliant/base/progress.h"

namespace pliant {

/// A bounded nonlinear least-squares problem: minimise 1/2 |residual(p)|^2 with lower <= p <= upper
/// and linear combinations of p that must not be negative.
struct LeastSquaresProblem {
  /// Fills the residual and, unless null, its Jacobian; returns false where p has no residual.
  using Evaluate = std::function<bool(const Eigen::VectorXd& p, Eigen::VectorXd& residual,
                                      Eigen::MatrixXd* jacobian)>;

  Evaluate evaluate;
  int residuals = 0;
  Eigen::VectorXd lower;  ///< equal to `upper` where a parameter is fixed
  Eigen::VectorXd upper;
  Eigen::VectorXd scale;              ///< a change of each parameter that matters, > 0
  Eigen::MatrixXd not_negative = {};  ///< rows A with A p >= 0; none: no rows
};

struct LeastSquaresOptions {
  int max_iterations = 200;
  double function_tolerance = 1e-15;   ///< relative change of the cost
  double gradient_tolerance = 1e-14;   ///< of the scaled problem
  double parameter_tolerance = 1e-11;  ///< relative change of the scaled parameters
  /// A cost above this after `patience` iterations is not worth more of them.
  double hopeless_cost = std::numeric_limits<double>::infinity();
  int patience = 0;
};

struct LeastSquaresSummary {
  Eigen::VectorXd parameters;
  double cost = 0;  ///< 1/2 |residual|^2
  bool converged = false;
  int iterations = 0;
};

/// The cost at some values; infinite where they have no residual.
double cost_at(const LeastSquaresProblem& problem, const Eigen::VectorXd& values);

/// Trust-region Levenberg-Marquardt with bounds (Ceres). Where a solution violates `not_negative`
/// the search goes on with an augmented Lagrangian until it does not.
/// @param start  is moved into the bounds
/// @return cost infinity and `converged` false where `start` has no residual
/// @throws Interrupted
LeastSquaresSummary solve_least_squares(const LeastSquaresProblem& problem,
                                        const Eigen::VectorXd& start,
                                        const LeastSquaresOptions& options, const StopToken& stop);

}  // namespace pliant
