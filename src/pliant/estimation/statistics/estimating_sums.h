#pragma once

#include <vector>

#include <Eigen/Core>

namespace pliant {

/// What a group of rows (a half cycle, a frame) adds to the equations that the estimate solves,
/// with residuals r and Jacobian J of rows divided by sd sqrt(L).
///
/// Each unknown may be told by certain experiments only (stages that are fitted one after the
/// other): a group adds to the equations of the unknowns that it tells, while its residuals depend
/// on all. So `slope` need not be symmetric.
struct GroupSum {
  int experiment = 0;       ///< index among the experiments
  Eigen::MatrixXd slope;    ///< G_i = J_told^T J: zero rows for unknowns that it does not tell
  Eigen::VectorXd part;     ///< g_i = J_told^T r: zero there likewise
  Eigen::MatrixXd scatter;  ///< M_i = J_told^T S^2 J_told: covariance of g_i under independent
                            ///< noise; S is 1 where rows count by their noise
};

/// The equations sum g_i + (prior) = 0 at an estimate.
struct EstimatingSums {
  std::vector<GroupSum> groups;
  /// Sum over priors of d d^T / sd^2, d being what a prior is about by the unknowns; zero or empty
  /// without priors. They are not divided by a correlation length.
  Eigen::MatrixXd priors;

  /// Number of unknowns.
  Eigen::Index unknowns() const { return groups.empty() ? priors.rows() : groups[0].part.size(); }
  Eigen::MatrixXd slope() const;    ///< G = sum of G_i + priors
  Eigen::MatrixXd scatter() const;  ///< M = sum of M_i + priors; G itself where all tell all
};

/// @param jacobian  rows of the group by unknowns, divided by sd sqrt(L)
/// @param residual  likewise
/// @param scatter   S of the rows
/// @param told      which unknowns the group tells; empty: all
GroupSum group_sum(int experiment, const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                   const Eigen::VectorXd& scatter, const std::vector<char>& told);
/// Of rows that count by their noise.
GroupSum group_sum(int experiment, const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                   const std::vector<char>& told = {});

/// Groups joined into clusters (half cycles into cycles, specimens, profiles), which keep the order
/// in which their labels first appear.
/// @param labels  one per group; a cluster lies within one experiment, or that of its first group
/// counts
std::vector<GroupSum> clustered(const std::vector<GroupSum>& groups,
                                const std::vector<int>& labels);

}  // namespace pliant
