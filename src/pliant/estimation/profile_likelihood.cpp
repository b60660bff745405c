#include "pliant/estimation/profile_likelihood.h"

#include <algorithm>
#include <cmath>

#include "pliant/estimation/statistics/profile_limits.h"
#include "pliant/math/quantiles.h"

namespace pliant {
namespace {

constexpr int kSteps = 8;     // values on each side of the estimate
constexpr double kReach = 4;  // standard errors on each side

}  // namespace

Profile profile_likelihood(const ComponentProblem& problem, const ComponentFit& fit,
                           Eigen::Index index, const StopToken& stop) {
  const LawFit& best = fit.fit;
  const double estimate = best.solution.parameters(index);
  const double std_error = fit.uncertainty.std_error(index);
  const bool known =
      std::isfinite(std_error) && fit.uncertainty.identified[static_cast<size_t>(index)];
  const double step = kReach / kSteps * (known ? std_error : best.limits.scale(index) / 4);

  Profile profile;
  profile.parameter = best.limits.names[static_cast<size_t>(index)];
  profile.unit = best.limits.units[static_cast<size_t>(index)];
  if (std::isfinite(std_error)) profile.std_error = std_error;
  const double unit = fit.uncertainty.variance * fit.uncertainty.correlation_length;

  std::vector<std::pair<double, double>> points{{estimate, 0.0}};
  for (const int side : {-1, 1}) {
    LawFit neighbour = best;
    for (int i = 1; i <= kSteps; ++i) {
      const double value = std::clamp(estimate + side * i * step, best.limits.lower(index),
                                      best.limits.upper(index));
      if (value == points.back().first) break;  // at the bound
      LawFit held = neighbour;
      held.limits.lower(index) = held.limits.upper(index) = value;
      held.solution.parameters(index) = value;
      held = refit(problem, held, stop);
      points.push_back({value, 2 * (held.solution.cost - best.solution.cost) / unit});
      neighbour = held;
    }
  }
  std::sort(points.begin(), points.end());
  size_t middle = 0;
  for (const auto& [value, rise] : points) {
    if (value == estimate) middle = profile.value.size();
    profile.value.push_back(value);
    profile.delta_chi2.push_back(rise);
  }
  const ProfileCrossings crossings =
      profile_crossings(profile.value, profile.delta_chi2, middle, chi_square_quantile(0.95, 1));
  profile.lower = crossings.lower;
  profile.upper = crossings.upper;
  return profile;
}

}  // namespace pliant
