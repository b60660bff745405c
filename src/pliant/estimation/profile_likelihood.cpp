#include "pliant/estimation/profile_likelihood.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr double kThreshold = 3.841458820694124;  // 95 % of chi squared with one degree of freedom
constexpr int kSteps = 8;                         // values on each side of the estimate
constexpr double kReach = 4;                      // standard errors on each side

std::optional<double> crossing(const Profile& profile, size_t from, int step) {
  for (auto i = static_cast<std::ptrdiff_t>(from);; i += step) {
    const auto next = i + step;
    if (next < 0 || next >= static_cast<std::ptrdiff_t>(profile.value.size())) return std::nullopt;
    const auto a = static_cast<size_t>(i), b = static_cast<size_t>(next);
    if (profile.delta_chi2[b] < kThreshold) continue;
    // Delta chi2 is close to a parabola: its root is close to a straight line.
    const double low = std::sqrt(std::max(profile.delta_chi2[a], 0.0));
    const double high = std::sqrt(profile.delta_chi2[b]);
    const double share = (std::sqrt(kThreshold) - low) / (high - low);
    return profile.value[a] + share * (profile.value[b] - profile.value[a]);
  }
}

}  // namespace

Profile profile_likelihood(const ComponentProblem& problem, const ComponentFit& fit,
                           Eigen::Index index, const StopToken& stop) {
  const LawFit& best = fit.fit;
  const Unknown& own = best.unknowns[static_cast<size_t>(index)];
  const double estimate = best.solution.parameters(index);
  const double std_error = fit.uncertainty.std_error(index);
  const bool known =
      std::isfinite(std_error) && fit.uncertainty.identified[static_cast<size_t>(index)];
  const double step = kReach / kSteps * (known ? std_error : own.scale / 4);

  Profile profile;
  profile.parameter = own.name;
  profile.unit = own.unit;
  if (std::isfinite(std_error)) profile.std_error = std_error;
  const double unit = fit.uncertainty.variance * fit.uncertainty.correlation_length;

  std::vector<std::pair<double, double>> points{{estimate, 0.0}};
  for (const int side : {-1, 1}) {
    LawFit neighbour = best;
    for (int i = 1; i <= kSteps; ++i) {
      const double value = std::clamp(estimate + side * i * step, own.lower, own.upper);
      if (value == points.back().first) break;  // at the bound
      LawFit held = neighbour;
      Unknown& unknown = held.unknowns[static_cast<size_t>(index)];
      unknown.lower = unknown.upper = value;
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
  profile.lower = crossing(profile, middle, -1);
  profile.upper = crossing(profile, middle, 1);
  return profile;
}

}  // namespace pliant
