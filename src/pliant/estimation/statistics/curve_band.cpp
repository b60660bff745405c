#include "pliant/estimation/statistics/curve_band.h"

#include <algorithm>
#include <cmath>

#include "pliant/math/quantiles.h"

namespace pliant {

std::optional<double> band_half_width(const Eigen::VectorXd& gradient,
                                      const ParameterErrors& errors, const Eigen::VectorXd& unit) {
  if (is_unseen(gradient.cwiseProduct(unit), errors.unseen)) return std::nullopt;
  const double variance = gradient.dot(errors.covariance * gradient);
  if (!(variance > 0)) return 0;
  const Eigen::VectorXd added = gradient.cwiseAbs2().cwiseProduct(errors.covariance.diagonal());
  const double mean_inverse = added.cwiseQuotient(errors.degrees).sum() / added.sum();
  return student_quantile_95(1 / mean_inverse) * std::sqrt(variance);
}

}  // namespace pliant
