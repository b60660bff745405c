#include "pliant/estimation/statistics/estimating_sums.h"

#include <map>

#include "pliant/base/assert.h"

namespace pliant {

Eigen::MatrixXd EstimatingSums::slope() const {
  const Eigen::Index n = unknowns();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  if (priors.size() > 0) sum += priors;
  for (const GroupSum& group : groups) sum += group.slope;
  return sum;
}

Eigen::MatrixXd EstimatingSums::scatter() const {
  const Eigen::Index n = unknowns();
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  if (priors.size() > 0) sum += priors;
  for (const GroupSum& group : groups) sum += group.scatter;
  return sum;
}

GroupSum group_sum(int experiment, const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                   const std::vector<char>& told) {
  return group_sum(experiment, jacobian, residual, Eigen::VectorXd::Ones(residual.size()), told);
}

GroupSum group_sum(int experiment, const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                   const Eigen::VectorXd& scatter, const std::vector<char>& told) {
  PLIANT_ASSERT(jacobian.rows() == residual.size(), "one residual per row");
  Eigen::MatrixXd telling = jacobian;
  for (size_t u = 0; u < told.size(); ++u) {
    if (!told[u]) telling.col(static_cast<Eigen::Index>(u)).setZero();
  }
  const Eigen::MatrixXd scattered = scatter.asDiagonal() * telling;
  return {experiment, telling.transpose() * jacobian, telling.transpose() * residual,
          scattered.transpose() * scattered};
}

std::vector<GroupSum> clustered(const std::vector<GroupSum>& groups,
                                const std::vector<int>& labels) {
  PLIANT_ASSERT(groups.size() == labels.size(), "one label per group");
  std::vector<GroupSum> clusters;
  std::map<int, size_t> cluster_of;
  for (size_t i = 0; i < groups.size(); ++i) {
    const auto [known, is_new] = cluster_of.emplace(labels[i], clusters.size());
    if (is_new) {
      clusters.push_back(groups[i]);
      continue;
    }
    GroupSum& cluster = clusters[known->second];
    cluster.slope += groups[i].slope;
    cluster.part += groups[i].part;
    cluster.scatter += groups[i].scatter;
  }
  return clusters;
}

}  // namespace pliant
