#include "pliant/estimation/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SVD>

#include "pliant/estimation/autocorrelation.h"
#include "pliant/math/quantiles.h"

namespace pliant {
namespace {

constexpr double kBoundShare = 1e-6;   // of the scale: nearer than this counts as at the bound
constexpr double kRankShare = 1e-12;   // singular values below this share of the largest are zero
constexpr double kUnseenShare = 1e-6;  // of a unit vector
constexpr double kIdentifiedShare = 0.05;  // of the scale

bool is_at_bound(const LawFit& fit, Eigen::Index i) {
  const double gap = kBoundShare * fit.limits.scale(i);
  const double value = fit.solution.parameters(i);
  return value - fit.limits.lower(i) <= gap || fit.limits.upper(i) - value <= gap;
}

// Mean over the specimens, by number of rows.
double correlation_length(const ComponentProblem& problem, const Eigen::VectorXd& residual) {
  double weighted = 0;
  Eigen::Index row = 0;
  for (size_t e = 0; e < problem.experiments().size(); ++e) {
    const MeasuredPath& path = problem.experiments()[e]->path();
    std::vector<double> series;
    for (size_t i = 0; i < path.specimen.size(); ++i) {
      if (problem.used(e)[i]) series.push_back(residual(row++));
      const bool last = i + 1 == path.specimen.size() || path.specimen[i + 1] != path.specimen[i];
      if (!last) continue;
      weighted += integrated_autocorrelation(series) * static_cast<double>(series.size());
      series.clear();
    }
  }
  return weighted / static_cast<double>(row);
}

bool all_noise_is_stated(const ComponentProblem& problem) {
  return std::all_of(problem.noise().begin(), problem.noise().end(),
                     [](const RowNoise& noise) { return noise.stated; });
}

using Svd = Eigen::BDCSVD<Eigen::MatrixXd>;

Uncertainty nothing_known(Eigen::Index count) {
  Uncertainty result;
  result.covariance = Eigen::MatrixXd::Zero(count, count);
  result.std_error = Eigen::VectorXd::Constant(count, std::numeric_limits<double>::quiet_NaN());
  result.half_width = result.std_error;
  result.at_bound.assign(static_cast<size_t>(count), 0);
  result.identified.assign(static_cast<size_t>(count), 0);
  return result;
}

// Unknowns that are not fixed; those at a bound are marked. What the noise has pushed there might
// be elsewhere, and the others with it.
std::vector<Eigen::Index> free_unknowns(const LawFit& fit, Uncertainty& result) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < fit.solution.parameters.size(); ++i) {
    const auto index = static_cast<size_t>(i);
    if (fit.limits.fixed[index]) continue;
    result.at_bound[index] = is_at_bound(fit, i) ? 1 : 0;
    free.push_back(i);
  }
  return free;
}

// 1 / s^2 of the singular values that are not zero for rounding, else 0.
Eigen::VectorXd inverse_squares(const Eigen::VectorXd& singular_values) {
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(singular_values.size());
  for (Eigen::Index i = 0; i < inverse.size(); ++i) {
    const double s = singular_values(i);
    if (s > kRankShare * singular_values(0)) inverse(i) = 1 / (s * s);
  }
  return inverse;
}

// Whether the unknown takes part in a direction that the data does not see.
bool is_unseen(const Svd& svd, const Eigen::VectorXd& inverse, Eigen::Index unknown) {
  for (Eigen::Index k = 0; k < inverse.size(); ++k) {
    if (inverse(k) == 0 && std::abs(svd.matrixV()(unknown, k)) > kUnseenShare) return true;
  }
  return false;
}

// How far the residuals scatter, and how many of them are independent. False where they cannot
// tell: with as many unknowns as rows they vanish whatever the noise.
bool measure_scatter(const ComponentProblem& problem, const Eigen::VectorXd& residual,
                     size_t unknowns, bool noise_is_stated, Uncertainty& result) {
  const double spare = static_cast<double>(residual.size()) - static_cast<double>(unknowns);
  if (spare < 0 || (spare == 0 && !noise_is_stated)) return false;
  result.degrees_of_freedom = std::max(spare, 1.0);
  result.variance = residual.squaredNorm() / result.degrees_of_freedom;
  if (noise_is_stated) result.variance = std::max(result.variance, 1.0);
  result.correlation_length = correlation_length(problem, residual);
  return true;
}

// Correlated rows leave fewer independent residuals to judge the noise by.
double quantile_of(const Uncertainty& result) {
  return student_quantile_95(std::max(result.degrees_of_freedom / result.correlation_length, 1.0));
}

}  // namespace

Uncertainty estimate_uncertainty(const ComponentProblem& problem, const LawFit& fit) {
  return linearised_uncertainty(problem.least_squares(fit.law, fit.limits), problem, fit,
                                all_noise_is_stated(problem));
}

Uncertainty linearised_uncertainty(const LeastSquaresProblem& least_squares,
                                   const ComponentProblem& problem, const LawFit& fit,
                                   bool noise_is_stated) {
  Uncertainty result = nothing_known(fit.solution.parameters.size());
  const std::vector<Eigen::Index> free = free_unknowns(fit, result);
  Eigen::VectorXd residual(least_squares.residuals);
  Eigen::MatrixXd jacobian;
  if (free.empty() || !least_squares.evaluate(fit.solution.parameters, residual, &jacobian)) {
    return result;
  }
  const Eigen::VectorXd scale = fit.limits.scale(free);
  const Svd svd(jacobian(Eigen::all, free) * scale.asDiagonal(),
                Eigen::ComputeThinU | Eigen::ComputeThinV);
  result.singular_values = svd.singularValues();
  if (!measure_scatter(problem, residual, free.size(), noise_is_stated, result)) return result;

  const Eigen::VectorXd inverse = inverse_squares(result.singular_values);
  const Eigen::MatrixXd inverse_normal =
      svd.matrixV() * inverse.asDiagonal() * svd.matrixV().transpose();
  result.covariance(free, free) = result.variance * result.correlation_length *
                                  (scale.asDiagonal() * inverse_normal * scale.asDiagonal());
  const double quantile = quantile_of(result);
  for (size_t i = 0; i < free.size(); ++i) {
    const Eigen::Index unknown = free[i];
    const auto row = static_cast<Eigen::Index>(i);
    if (result.at_bound[static_cast<size_t>(unknown)] || is_unseen(svd, inverse, row)) continue;
    result.std_error(unknown) = std::sqrt(result.covariance(unknown, unknown));
    result.half_width(unknown) = quantile * result.std_error(unknown);
    const double tolerated =
        std::max(std::abs(fit.solution.parameters(unknown)), kIdentifiedShare * scale(row));
    result.identified[static_cast<size_t>(unknown)] =
        result.half_width(unknown) < tolerated ? 1 : 0;
  }
  return result;
}

}  // namespace pliant
