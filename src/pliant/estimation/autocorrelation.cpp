#include "pliant/estimation/autocorrelation.h"

#include <cmath>
#include <cstddef>

namespace pliant {

double integrated_autocorrelation(const std::vector<double>& series) {
  const auto n = series.size();
  if (n < 8) return 1;
  double variance = 0;
  for (const double r : series) variance += r * r;
  if (variance == 0) return 1;
  double sum = 1;
  for (std::size_t lag = 1; lag < n / 2; ++lag) {
    double covariance = 0;
    for (std::size_t i = lag; i < n; ++i) covariance += series[i] * series[i - lag];
    const double correlation = covariance / variance;
    if (correlation < 2 / std::sqrt(static_cast<double>(n))) break;
    sum += 2 * correlation;
  }
  return sum;
}

}  // namespace pliant
