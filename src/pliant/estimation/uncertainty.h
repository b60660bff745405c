#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/law_fit.h"

namespace pliant {

/// What the data says about the unknowns of a fit.
struct Uncertainty {
  Eigen::MatrixXd covariance;  ///< zero rows and columns for fixed parameters
  Eigen::VectorXd std_error;   ///< NaN for fixed parameters and those at a bound
  Eigen::VectorXd half_width;  ///< of the 95 % interval; NaN likewise
  std::vector<char> at_bound;
  std::vector<char> identified;
  Eigen::VectorXd singular_values;  ///< of the weighted Jacobian in units of the parameters' scales
  double variance = 0;              ///< residual variance in units of the stated or estimated noise
  double correlation_length = 1;    ///< rows that count as one because their residuals go together
  double degrees_of_freedom = 0;
};

/// Linearised uncertainty of a fit at its solution.
///
/// The covariance is s^2 L (J^T J)^-1: s^2 the residual variance (never below 1 where all noise is
/// stated), L the integrated autocorrelation of the residuals along the path, so that densely
/// sampled model error does not count as independent noise. Intervals use Student's t. A parameter
/// at a bound has no interval, but the others' are as wide as if it could leave it.
///
/// Without a stated noise, as many rows as unknowns determine nothing: all standard errors are NaN.
///
/// A parameter is identified when its 95 % interval excludes zero or is narrower than 5 % of its
/// scale in the data, and it is neither fixed nor at a bound.
Uncertainty estimate_uncertainty(const ComponentProblem& problem, const LawFit& fit);

/// The same for any least-squares problem at the parameters `fit.solution`, whose residuals stand
/// in the order of the component problem's used rows.
/// @param noise_is_stated  residuals are in units of a stated noise: their variance counts as at
/// least 1
Uncertainty linearised_uncertainty(const LeastSquaresProblem& least_squares,
                                   const ComponentProblem& problem, const LawFit& fit,
                                   bool noise_is_stated);

}  // namespace pliant
