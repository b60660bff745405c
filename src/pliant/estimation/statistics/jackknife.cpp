// The delete-one-group jackknife of covariance.h.

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SVD>

#include "pliant/estimation/statistics/covariance.h"

namespace pliant {
namespace {

constexpr double kLeftWithout = 1e-3;     // of the information on an unknown, without one group
constexpr double kNoInformation = 1e-12;  // of G^-1 G_i: a group that tells nothing

/// All in units in which the formula's standard errors are 1.
struct Scaled {
  Eigen::MatrixXd inverse;  // of G
  Eigen::MatrixXd scatter;  // M
  std::vector<GroupSum> groups;
};

Scaled scaled(const EstimatingSums& sums, const Eigen::MatrixXd& inverse_slope,
              const Eigen::VectorXd& scale) {
  Scaled result;
  const auto times = [&](const Eigen::MatrixXd& m) -> Eigen::MatrixXd {
    return scale.asDiagonal() * m * scale.asDiagonal();
  };
  const auto per_scale = scale.cwiseInverse().asDiagonal();
  result.inverse = per_scale * inverse_slope * per_scale;
  result.scatter = times(sums.scatter());
  for (const GroupSum& group : sums.groups) {
    result.groups.push_back({group.experiment, times(group.slope), scale.asDiagonal() * group.part,
                             times(group.scatter)});
  }
  return result;
}

/// (G - G_i)^-1, and which unknowns are lost without the group.
struct Without {
  Eigen::MatrixXd inverse;
  std::vector<Eigen::Index> lost;
};

Without without(const Scaled& all, const GroupSum& group) {
  const Eigen::Index n = all.inverse.rows();
  // G^-1 (G - G_i): the part of the information that is left.
  const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(n, n) - all.inverse * group.slope;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(left, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(n);
  Without result;
  Eigen::VectorXd lost = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    if (svd.singularValues()(k) > kLeftWithout) {
      inverse(k) = 1 / svd.singularValues()(k);
    } else {
      lost += svd.matrixV().col(k).cwiseAbs2();
    }
  }
  result.inverse = svd.matrixV() * inverse.asDiagonal() * svd.matrixU().transpose() * all.inverse;
  for (Eigen::Index u = 0; u < n; ++u) {
    if (lost(u) > kLeftWithout) result.lost.push_back(u);
  }
  return result;
}

/// The changes of the estimate without each group, and what they are under independent noise.
struct Changes {
  Eigen::MatrixXd change;            // unknowns by groups
  std::vector<Eigen::MatrixXd> row;  // per group: (G - G_i)^-1, row u belongs to unknown u
  std::vector<char> lost;            // unknowns that a group tells alone
};

Changes changes_without(const Scaled& all) {
  const Eigen::Index n = all.inverse.rows();
  Changes result;
  result.change.resize(n, static_cast<Eigen::Index>(all.groups.size()));
  result.lost.assign(static_cast<size_t>(n), 0);
  for (size_t i = 0; i < all.groups.size(); ++i) {
    Without left = without(all, all.groups[i]);
    result.change.col(static_cast<Eigen::Index>(i)) = left.inverse * all.groups[i].part;
    for (const Eigen::Index u : left.lost) result.lost[static_cast<size_t>(u)] = 1;
    result.row.push_back(std::move(left.inverse));
  }
  return result;
}

/// Covariance over the groups of one unknown's changes under independent noise: g_i has M_i less
/// what the fit takes, Cov(g_i, g_j) = d_ij M_i - M_i G^-T G_j^T - G_i G^-1 M_j
/// + G_i G^-1 M G^-T G_j^T.
Eigen::MatrixXd changes_under_noise(const Scaled& all, const Changes& changes, Eigen::Index u) {
  const auto m = static_cast<Eigen::Index>(all.groups.size());
  const Eigen::Index n = all.inverse.rows();
  Eigen::MatrixXd scattered(n, m), taken(n, m);  // M_i a_i and G^-T G_i^T a_i
  Eigen::VectorXd own(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const GroupSum& group = all.groups[static_cast<size_t>(i)];
    const Eigen::VectorXd a = changes.row[static_cast<size_t>(i)].row(u).transpose();
    scattered.col(i) = group.scatter * a;
    taken.col(i) = all.inverse.transpose() * (group.slope.transpose() * a);
    own(i) = a.dot(scattered.col(i));
  }
  const Eigen::MatrixXd cross = scattered.transpose() * taken;
  Eigen::MatrixXd covariance = taken.transpose() * all.scatter * taken - cross - cross.transpose();
  covariance.diagonal() += own;
  return covariance;
}

}  // namespace

JackknifeVariance jackknife_variance(const EstimatingSums& sums, const FormulaCovariance& formula,
                                     const Eigen::VectorXd& unit) {
  const Eigen::Index n = unit.size();
  JackknifeVariance result{Eigen::VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN()),
                           Eigen::VectorXd::Zero(n)};
  if (sums.groups.size() < 2) return result;
  Eigen::VectorXd sd = formula.covariance.diagonal().cwiseSqrt();
  for (Eigen::Index u = 0; u < n; ++u) {
    if (!(sd(u) > 0)) sd(u) = unit(u);
  }
  const Scaled all = scaled(sums, formula.inverse_slope, sd);
  const Changes changes = changes_without(all);
  const Eigen::MatrixXd priors =
      sums.priors.size() > 0 ? Eigen::MatrixXd(sd.asDiagonal() * sums.priors * sd.asDiagonal())
                             : Eigen::MatrixXd(Eigen::MatrixXd::Zero(n, n));
  const Eigen::VectorXd by_priors = (all.inverse * priors * all.inverse.transpose()).diagonal();
  for (Eigen::Index u = 0; u < n; ++u) {
    if (changes.lost[static_cast<size_t>(u)]) continue;
    const Eigen::MatrixXd noise = changes_under_noise(all, changes, u);
    if (noise.trace() <= kNoInformation) continue;
    const double degrees = noise.trace() * noise.trace() / noise.squaredNorm();
    const double by_data =  // the formula's variance is 1
        (1 - by_priors(u)) * changes.change.row(u).squaredNorm() / noise.trace();
    const double share = by_data / (by_data + by_priors(u));
    result.variance(u) = sd(u) * sd(u) * (by_data + by_priors(u));
    result.degrees(u) = degrees / std::max(share * share, kNoInformation);
  }
  return result;
}

}  // namespace pliant
