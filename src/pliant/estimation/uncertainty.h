#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/measured_noise.h"
#include "pliant/estimation/statistics/covariance.h"
#include "pliant/estimation/statistics/curve_error.h"
#include "pliant/estimation/statistics/determination.h"
#include "pliant/estimation/statistics/outliers.h"

namespace pliant {

/// What the data says about the unknowns of a fit.
struct Uncertainty {
  Eigen::MatrixXd covariance;                ///< zero rows and columns for what is fixed or unseen
  Eigen::VectorXd std_error;                 ///< NaN for what is fixed, unseen or at a bound
  Eigen::VectorXd half_width;                ///< of the 95 % interval; NaN likewise
  Eigen::VectorXd degrees;                   ///< of freedom
  Eigen::VectorXd formula_sd, jackknife_sd;  ///< the larger of which is the standard error
  std::vector<char> at_bound;
  std::vector<Determination> determination;
  std::vector<std::string> told_by;  ///< the experiments, by their share of the information
  MeasuredNoise noise;
  std::vector<std::vector<Outlier>> outliers;  ///< of each part
  Eigen::VectorXd singular_values;  ///< of the weighted Jacobian in units of the scales; empty for
                                    ///< unknowns of several stages
  Eigen::MatrixXd unseen;  ///< all unknowns x directions that nothing is known of, in units of the
                           ///< scales

  /// The error of something with these derivatives by all unknowns; nothing where it depends on
  /// what the data does not see.
  std::optional<CurveError> error_of(const Eigen::VectorXd& gradient) const;

  /// @name For `error_of`
  /// @{
  std::vector<Eigen::Index> free;
  Eigen::VectorXd unit;
  ParameterErrors errors;  ///< of the free unknowns
  /// @}
};

/// What a fit of many unknowns says of some, told by some of its parts.
/// @param unknowns  ascending
Uncertainty part_of(const Uncertainty& all, const std::vector<Eigen::Index>& unknowns,
                    const std::vector<std::size_t>& parts);

/// Adds an error that no repetition shows to the standard errors, intervals and bands of a fit: its
/// square to the variance, 1.96 of it to a half width in quadrature.
/// @param bias  of each unknown, either sign
void add_systematic(const Eigen::VectorXd& bias, const std::vector<Unknown>& unknowns,
                    const Eigen::VectorXd& values, Uncertainty& uncertainty);

/// Linearised uncertainty of a fit at its solution.
///
/// Standard errors are the larger ones of the formula, in which the rows of a correlation length
/// count as one, and of the jackknife by frames, by cycles and by specimens. An unknown at a bound
/// has no interval, but the others' are as wide as if it could leave it. With a prior an unknown is
/// determined where the data say more than the prior.
/// @param told  of each part; unknowns that were fitted one after the other are told by some alone:
///              each makes the residuals of its own parts stand upright on its own derivative, and
///              carries the errors of earlier ones
/// @throws SolverError where the values predict nothing
Uncertainty uncertainty_of(const Problem& problem, const Eigen::VectorXd& values,
                           const ToldUnknowns& told = {});

}  // namespace pliant
