#include "pliant/estimation/statistics/covariance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SVD>

#include "pliant/base/assert.h"
#include "pliant/math/quantiles.h"

namespace pliant {
namespace {

constexpr double kRankShare = 1e-12;   // of the largest singular value of G: below it is none
constexpr double kUnseenShare = 1e-6;  // of a unit vector
constexpr double kFewDegrees = 3;      // a variance of fewer is hardly known

using Svd = Eigen::JacobiSVD<Eigen::MatrixXd>;

/// Equations and unknowns in units of what they tell: G_uu = 1. Unlike units of the unknowns alone,
/// that leaves small singular values to true degeneracy.
Eigen::VectorXd informed_units(const Eigen::MatrixXd& slope, const Eigen::VectorXd& unit) {
  Eigen::VectorXd scale(unit.size());
  const double largest = (slope.diagonal().array() * unit.array().square()).maxCoeff();
  for (Eigen::Index u = 0; u < unit.size(); ++u) {
    const double information = slope(u, u) * unit(u) * unit(u);
    const bool informed = information > kRankShare * kRankShare * largest;
    scale(u) = unit(u) / (informed ? std::sqrt(information) : std::sqrt(largest));
  }
  return scale;
}

/// Orthonormal columns that span the same directions in other units of the unknowns.
Eigen::MatrixXd in_units(const Eigen::MatrixXd& directions, const Eigen::VectorXd& from,
                         const Eigen::VectorXd& to) {
  if (directions.cols() == 0) return directions;
  const Eigen::MatrixXd converted = (from.array() / to.array()).matrix().asDiagonal() * directions;
  return Svd(converted, Eigen::ComputeThinU).matrixU();
}

/// Satterthwaite: variances of experiments with their own degrees of freedom add up.
Eigen::VectorXd added_degrees(const EstimatingSums& sums, const Eigen::MatrixXd& inverse,
                              const std::vector<double>& noise_degrees) {
  const Eigen::Index n = inverse.rows();
  Eigen::MatrixXd shares =
      Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(noise_degrees.size()));
  Eigen::VectorXd total = Eigen::VectorXd::Zero(n);
  if (sums.priors.size() > 0) total = (inverse * sums.priors * inverse.transpose()).diagonal();
  for (const GroupSum& group : sums.groups) {
    PLIANT_ASSERT(static_cast<size_t>(group.experiment) < noise_degrees.size(),
                  "every experiment's noise has degrees of freedom");
    shares.col(group.experiment) += (inverse * group.scatter).cwiseProduct(inverse).rowwise().sum();
  }
  total += shares.rowwise().sum();
  Eigen::VectorXd degrees(n);
  for (Eigen::Index u = 0; u < n; ++u) {
    double sum = 0;
    for (size_t e = 0; e < noise_degrees.size(); ++e) {
      const double share = shares(u, static_cast<Eigen::Index>(e)) / total(u);
      sum += share * share / noise_degrees[e];
    }
    degrees(u) = sum > 0 ? std::max(1 / sum, 1.0) : std::numeric_limits<double>::infinity();
  }
  return degrees;
}

}  // namespace

FormulaCovariance formula_covariance(const EstimatingSums& sums, const Eigen::VectorXd& unit,
                                     const std::vector<double>& noise_degrees) {
  const Eigen::MatrixXd slope = sums.slope();
  const Eigen::VectorXd scale = informed_units(slope, unit);
  const Svd svd(scale.asDiagonal() * slope * scale.asDiagonal(),
                Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd& singular = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < singular.size() && singular(rank) > kRankShare * singular(0)) ++rank;
  FormulaCovariance result;
  result.inverse_slope = scale.asDiagonal() * svd.matrixV().leftCols(rank) *
                         singular.head(rank).cwiseInverse().asDiagonal() *
                         svd.matrixU().leftCols(rank).transpose() * scale.asDiagonal();
  const Eigen::MatrixXd& inverse = result.inverse_slope;
  const Eigen::MatrixXd covariance = inverse * sums.scatter() * inverse.transpose();
  result.covariance = (covariance + covariance.transpose()) / 2;
  result.degrees = added_degrees(sums, inverse, noise_degrees);
  result.unseen = in_units(svd.matrixV().rightCols(singular.size() - rank), scale, unit);
  return result;
}

ParameterErrors parameter_errors(const EstimatingSums& sums, const Eigen::VectorXd& unit,
                                 const std::vector<double>& noise_degrees) {
  const FormulaCovariance formula = formula_covariance(sums, unit, noise_degrees);
  const JackknifeVariance jackknife = jackknife_variance(sums, formula, unit);
  const Eigen::Index n = unit.size();
  ParameterErrors errors;
  errors.formula_sd = formula.covariance.diagonal().cwiseSqrt();
  errors.jackknife_sd = jackknife.variance.cwiseSqrt();
  errors.sd = errors.formula_sd;
  errors.degrees = formula.degrees;
  errors.covariance = formula.covariance;
  errors.unseen = formula.unseen;
  errors.half_width.resize(n);
  for (Eigen::Index u = 0; u < n; ++u) {
    const double formula_sd = errors.formula_sd(u), jackknife_sd = errors.jackknife_sd(u);
    const bool groups_know = jackknife.degrees(u) >= kFewDegrees;
    const bool rows_know = formula.degrees(u) >= kFewDegrees;
    if (jackknife_sd > formula_sd || (groups_know && !rows_know && jackknife_sd > 0)) {
      errors.sd(u) = jackknife_sd;
      errors.degrees(u) = jackknife.degrees(u);
    } else {
      errors.degrees(u) = std::max(formula.degrees(u), jackknife.degrees(u));
    }
    const double factor = formula_sd > 0 ? errors.sd(u) / formula_sd : 1;
    errors.covariance.row(u) *= factor;
    errors.covariance.col(u) *= factor;
    if (is_unseen(Eigen::VectorXd::Unit(n, u), errors.unseen)) {
      errors.sd(u) = std::numeric_limits<double>::quiet_NaN();
    }
    errors.half_width(u) = student_quantile_95(errors.degrees(u)) * errors.sd(u);
  }
  return errors;
}

Eigen::MatrixXd raised_to(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& sd) {
  Eigen::VectorXd factor = Eigen::VectorXd::Ones(sd.size());
  for (Eigen::Index u = 0; u < sd.size(); ++u) {
    const double own = std::sqrt(covariance(u, u));
    if (own > 0 && sd(u) > own) factor(u) = sd(u) / own;
  }
  return factor.asDiagonal() * covariance * factor.asDiagonal();
}

bool is_unseen(const Eigen::VectorXd& gradient, const Eigen::MatrixXd& unseen) {
  return unseen.cols() > 0 &&
         (unseen.transpose() * gradient).norm() > kUnseenShare * gradient.norm();
}

}  // namespace pliant
