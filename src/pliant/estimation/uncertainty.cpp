#include "pliant/estimation/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SVD>

namespace pliant {
namespace {

constexpr double kBoundShare = 1e-6;  // of the scale: nearer than this counts as at the bound
constexpr double kRankShare = 1e-12;  // singular values below this share of the largest are zero
constexpr double kIdentifiedShare = 0.05;  // of the scale

bool is_at_bound(const LawFit& fit, Eigen::Index i) {
  const double gap = kBoundShare * fit.limits.scale(i);
  const double value = fit.solution.parameters(i);
  return value - fit.limits.lower(i) <= gap || fit.limits.upper(i) - value <= gap;
}

// 1 + 2 sum of the autocorrelations of one series, up to the first that noise could explain.
double integrated_autocorrelation(const std::vector<double>& series) {
  const auto n = series.size();
  if (n < 8) return 1;
  double variance = 0;
  for (const double r : series) variance += r * r;
  if (variance == 0) return 1;
  double sum = 1;
  for (size_t lag = 1; lag < n / 2; ++lag) {
    double covariance = 0;
    for (size_t i = lag; i < n; ++i) covariance += series[i] * series[i - lag];
    const double correlation = covariance / variance;
    if (correlation < 2 / std::sqrt(static_cast<double>(n))) break;
    sum += 2 * correlation;
  }
  return sum;
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

}  // namespace

double student_quantile_95(double degrees_of_freedom) {
  const double z = 1.959963984540054;
  const double n = std::max(degrees_of_freedom, 1.0);
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n);
}

Uncertainty estimate_uncertainty(const ComponentProblem& problem, const LawFit& fit) {
  return linearised_uncertainty(problem.least_squares(fit.law, fit.limits), problem, fit,
                                all_noise_is_stated(problem));
}

Uncertainty linearised_uncertainty(const LeastSquaresProblem& least_squares,
                                   const ComponentProblem& problem, const LawFit& fit,
                                   bool noise_is_stated) {
  const Eigen::Index count = fit.solution.parameters.size();
  Uncertainty result;
  result.covariance = Eigen::MatrixXd::Zero(count, count);
  result.std_error = Eigen::VectorXd::Constant(count, std::numeric_limits<double>::quiet_NaN());
  result.half_width = result.std_error;
  result.at_bound.assign(static_cast<size_t>(count), 0);
  result.identified.assign(static_cast<size_t>(count), 0);

  std::vector<Eigen::Index> free;
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto index = static_cast<size_t>(i);
    if (fit.limits.fixed[index]) continue;
    if (is_at_bound(fit, i)) {
      result.at_bound[index] = 1;
    } else {
      free.push_back(i);
    }
  }
  Eigen::VectorXd residual(least_squares.residuals);
  Eigen::MatrixXd jacobian;
  if (free.empty() || !least_squares.evaluate(fit.solution.parameters, residual, &jacobian)) {
    return result;
  }

  Eigen::MatrixXd scaled = jacobian(Eigen::all, free);
  const Eigen::VectorXd scale = fit.limits.scale(free);
  scaled = scaled * scale.asDiagonal();
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
  result.singular_values = svd.singularValues();

  result.degrees_of_freedom =
      std::max<double>(least_squares.residuals - static_cast<double>(free.size()), 1);
  result.variance = residual.squaredNorm() / result.degrees_of_freedom;
  if (noise_is_stated) result.variance = std::max(result.variance, 1.0);
  result.correlation_length = correlation_length(problem, residual);
  // Correlated rows leave fewer independent residuals to judge the noise by.
  const double independent = std::max(result.degrees_of_freedom / result.correlation_length, 1.0);

  const double largest = result.singular_values(0);
  Eigen::VectorXd inverse_square = Eigen::VectorXd::Zero(result.singular_values.size());
  bool full_rank = true;
  for (Eigen::Index i = 0; i < inverse_square.size(); ++i) {
    const double s = result.singular_values(i);
    if (s > kRankShare * largest) {
      inverse_square(i) = 1 / (s * s);
    } else {
      full_rank = false;
    }
  }
  const Eigen::MatrixXd covariance =
      result.variance * result.correlation_length *
      (svd.matrixV() * inverse_square.asDiagonal() * svd.matrixV().transpose());
  const double quantile = student_quantile_95(independent);
  for (size_t i = 0; i < free.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    // A direction that the data does not see makes every parameter in it unknown.
    bool unseen = false;
    for (Eigen::Index k = 0; !full_rank && k < inverse_square.size(); ++k) {
      unseen = unseen || (inverse_square(k) == 0 && std::abs(svd.matrixV()(row, k)) > 1e-6);
    }
    for (size_t j = 0; j < free.size(); ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      result.covariance(free[i], free[j]) = covariance(row, column) * scale(row) * scale(column);
    }
    if (unseen) continue;
    result.std_error(free[i]) = std::sqrt(result.covariance(free[i], free[i]));
    result.half_width(free[i]) = quantile * result.std_error(free[i]);
    const double tolerated =
        std::max(std::abs(fit.solution.parameters(free[i])), kIdentifiedShare * scale(row));
    result.identified[static_cast<size_t>(free[i])] = result.half_width(free[i]) < tolerated;
  }
  return result;
}

}  // namespace pliant
