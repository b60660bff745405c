#include "pliant/estimation/statistics/curve_error.h"

#include <algorithm>
#include <cmath>

#include "pliant/math/quantiles.h"

namespace pliant {

std::optional<CurveError> curve_error(const Eigen::VectorXd& gradient,
                                      const ParameterErrors& errors, const Eigen::VectorXd& unit) {
  if (is_unseen(gradient.cwiseProduct(unit), errors.unseen)) return std::nullopt;
  const double variance = gradient.dot(errors.covariance * gradient);
  if (!(variance > 0)) return CurveError{};
  const Eigen::VectorXd added = gradient.cwiseAbs2().cwiseProduct(errors.covariance.diagonal());
  const double mean_inverse = added.cwiseQuotient(errors.degrees).sum() / added.sum();
  const double std_error = std::sqrt(variance);
  return CurveError{std_error, student_quantile_95(1 / mean_inverse) * std_error};
}

}  // namespace pliant
