#include "pliant/estimation/statistics/outliers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

constexpr double kOwnLeverage = 1 - 1e-9;  // the row's prediction is the row

/// In units of the sd of the other rows.
double deleted(double studentised, double spare) {
  if (!std::isfinite(spare)) return studentised;
  const double left = spare - studentised * studentised;
  if (spare <= 1) return 0;
  if (left <= 0) return std::copysign(std::numeric_limits<double>::infinity(), studentised);
  return studentised * std::sqrt((spare - 1) / left);
}

}  // namespace

std::vector<Outlier> outliers(const Eigen::VectorXd& residual, const Eigen::VectorXd& leverage,
                              double spare, double limit) {
  PLIANT_ASSERT(residual.size() == leverage.size(), "one leverage per row");
  std::vector<Outlier> found;
  for (Eigen::Index row = 0; row < residual.size(); ++row) {
    if (leverage(row) >= kOwnLeverage) continue;
    const double in_sd = deleted(residual(row) / std::sqrt(1 - leverage(row)), spare);
    if (std::abs(in_sd) > limit) found.push_back({row, in_sd});
  }
  std::sort(found.begin(), found.end(), [](const Outlier& a, const Outlier& b) {
    return std::abs(a.in_sd) > std::abs(b.in_sd);
  });
  return found;
}

}  // namespace pliant
