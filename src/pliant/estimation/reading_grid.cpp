#include "pliant/estimation/reading_grid.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pliant {
namespace {

std::optional<double> grid_step(const Eigen::VectorXd& readings) {
  constexpr double kRounding = 1e-3;  // of the step
  std::vector<double> values(readings.begin(), readings.end());
  std::ranges::sort(values);
  const double range = values.back() - values.front();
  double step = range;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double gap = values[i] - values[i - 1];
    if (gap > 1e-9 * range) step = std::min(step, gap);
  }
  if (!(step > 0)) return std::nullopt;
  for (const double value : values) {
    const double steps = (value - values.front()) / step;
    if (std::abs(steps - std::round(steps)) > kRounding * std::max(steps, 1.0)) return std::nullopt;
  }
  return step;
}

}  // namespace

std::optional<double> coarse_step(const Eigen::VectorXd& readings, double misfit) {
  constexpr double kCoarse = 0.5;
  constexpr double kFewestSteps = 5, kMostSteps = 100;  // finer readings are no worse than others
  const std::optional<double> step = grid_step(readings);
  if (!step || *step / std::sqrt(12) < kCoarse * misfit) return std::nullopt;
  const double steps = (readings.maxCoeff() - readings.minCoeff()) / *step;
  if (steps < kFewestSteps || steps > kMostSteps) return std::nullopt;
  return step;
}

}  // namespace pliant
