#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/statistics/estimating_sums.h"

namespace pliant {

/// What the weights say: the covariance if noise were as independent as the correlation lengths
/// have it.
struct FormulaCovariance {
  Eigen::MatrixXd
      covariance;           ///< G^-1 M G^-T, that is G^-1 where all experiments tell all unknowns
  Eigen::VectorXd degrees;  ///< of freedom of each variance, >= 1 (Satterthwaite)
  Eigen::MatrixXd inverse_slope;  ///< G^-1, for `row_leverages`; G^+ where something is unseen
  /// Orthonormal columns: directions that neither data nor priors see, in units of `unit`. The
  /// covariance counts them as known exactly; numbers that depend on them are to be left blank.
  Eigen::MatrixXd unseen;
};

/// @param unit           of each unknown, > 0: what matters in the data
/// @param noise_degrees  of each experiment's sd (`ExperimentNoise::degrees`)
FormulaCovariance formula_covariance(const EstimatingSums& sums, const Eigen::VectorXd& unit,
                                     const std::vector<double>& noise_degrees);

/// What the groups say that were measured: by how much the estimate would change without each.
struct JackknifeVariance {
  Eigen::VectorXd variance;  ///< NaN where the groups cannot tell
  Eigen::VectorXd degrees;   ///< of freedom of each variance, >= 1; 0 where they cannot tell
};

/// Delete-one-group jackknife with change_i = (G - G_i)^-1 g_i, priors kept.
///
/// The sum of change_i^2 is too large where few groups tell an unknown (the estimator CR3 of
/// [Bell2002]); it is divided by what it would be in the mean under independent noise, over the
/// formula's variance, so that both agree there. Degrees of freedom are those of the same sum under
/// independent noise ([Bell2002]: Satterthwaite), which are fewer than groups - 1 where groups tell
/// unequally much. Fewer than two say nothing; neither does a group without which an unknown is
/// lost (less than a thousandth of its information left).
JackknifeVariance jackknife_variance(const EstimatingSums& sums, const FormulaCovariance& formula,
                                     const Eigen::VectorXd& unit);

/// How certain each unknown is.
struct ParameterErrors {
  Eigen::MatrixXd covariance;
  Eigen::VectorXd sd;          ///< NaN for unknowns that take part in an unseen direction
  Eigen::VectorXd degrees;     ///< of freedom, >= 1
  Eigen::VectorXd half_width;  ///< of the 95 % interval (Student's t), NaN likewise
  Eigen::VectorXd formula_sd;
  Eigen::VectorXd jackknife_sd;  ///< NaN where groups cannot tell
  Eigen::MatrixXd unseen;        ///< as in FormulaCovariance
};

/// The larger standard error of each unknown, formula's or jackknife's, with its own degrees of
/// freedom; the formula's, if it is larger, with the jackknife's where those are more: that nothing
/// exceeds it is known as well as groups tell. Where residuals go together over so many rows that
/// fewer than three are left to judge the formula by, groups that know better count alone. Rows and
/// columns of the formula's correlation matrix are scaled to them: that is a covariance again,
/// which the jackknife's own matrix of few groups is not.
ParameterErrors parameter_errors(const EstimatingSums& sums, const Eigen::VectorXd& unit,
                                 const std::vector<double>& noise_degrees);

/// The same correlations with larger standard errors.
/// @param sd  of each unknown; NaN or smaller ones leave it as it is
Eigen::MatrixXd raised_to(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& sd);

/// Whether an unknown (or the gradient of something by the unknowns, in units of `unit`) takes part
/// in a direction that the data does not see, by more than rounding.
bool is_unseen(const Eigen::VectorXd& gradient, const Eigen::MatrixXd& unseen);

}  // namespace pliant
