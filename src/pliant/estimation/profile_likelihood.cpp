#include "pliant/estimation/profile_likelihood.h"

#include <algorithm>
#include <cmath>

#include "pliant/estimation/statistics/profile_limits.h"
#include "pliant/math/quantiles.h"

namespace pliant {
namespace {

const double kThreshold = chi_square_quantile(0.95, 1);
constexpr int kSteps = 8;     // values on each side of the estimate
constexpr double kReach = 4;  // standard errors on each side

// By how much the variance of an unknown exceeds the formula's, where groups of rows disagree by
// more than the noise of rows: chi squared counts in units of it.
double squared_excess(const Uncertainty& uncertainty, Eigen::Index index) {
  const double ratio = uncertainty.covariance(index, index) /
                       (uncertainty.formula_sd(index) * uncertainty.formula_sd(index));
  return ratio > 1 ? ratio : 1;
}

// The square of Student's quantile over that of a known noise.
double squared_quantile(const Uncertainty& uncertainty, Eigen::Index index) {
  const double quantile = student_quantile_95(uncertainty.degrees(index));
  return quantile * quantile / kThreshold;
}

// The fit with an unknown held at a value, from a fit nearby.
LawFit held_at(const ComponentProblem& problem, LawFit near, Eigen::Index index, double value) {
  Unknown& unknown = near.unknowns[static_cast<size_t>(index)];
  unknown.lower = unknown.upper = value;
  near.solution.parameters(index) = value;
  return refit(problem, near);
}

}  // namespace

Profile profile_likelihood(const ComponentProblem& problem, const ComponentFit& fit,
                           Eigen::Index index) {
  const LawFit& best = fit.fit;
  const Unknown& own = best.unknowns[static_cast<size_t>(index)];
  const double estimate = best.solution.parameters(index);
  const double std_error = fit.uncertainty.std_error(index);
  const bool known =
      std::isfinite(std_error) &&
      fit.uncertainty.determination[static_cast<size_t>(index)] != Determination::none;
  const double step = kReach / kSteps * (known ? std_error : own.scale / 4);

  Profile profile;
  profile.parameter = own.name;
  profile.unit = own.unit;
  if (std::isfinite(std_error)) profile.std_error = std_error;

  const double unit =
      squared_excess(fit.uncertainty, index) * squared_quantile(fit.uncertainty, index);
  std::vector<std::pair<double, double>> points{{estimate, 0.0}};
  for (const int side : {-1, 1}) {
    LawFit neighbour = best;
    for (int i = 1; i <= kSteps; ++i) {
      const double value = std::clamp(estimate + side * i * step, own.lower, own.upper);
      if (value == points.back().first) break;  // at the bound
      neighbour = held_at(problem, neighbour, index, value);
      points.push_back({value, 2 * (neighbour.solution.cost - best.solution.cost) / unit});
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
      profile_crossings(profile.value, profile.delta_chi2, middle, kThreshold);
  profile.lower = crossings.lower;
  profile.upper = crossings.upper;
  return profile;
}

std::optional<double> limit_at_bound(const ComponentProblem& problem, const LawFit& fit,
                                     const Uncertainty& uncertainty, Eigen::Index index) {
  constexpr double kFarthest = 1e3;  // steps
  const Unknown& own = fit.unknowns[static_cast<size_t>(index)];
  LimitSearch search;
  search.estimate = fit.solution.parameters(index);
  const double unit = squared_excess(uncertainty, index);
  search.cost = fit.solution.cost / unit;
  const bool below = search.estimate - own.lower < own.upper - search.estimate;
  const double sd = std::sqrt(uncertainty.covariance(index, index));
  search.step = (below ? 1 : -1) * (sd > 0 ? sd : own.scale / 10);
  search.farthest = below ? std::min(own.upper, search.estimate + kFarthest * search.step)
                          : std::max(own.lower, search.estimate + kFarthest * search.step);
  search.degrees = uncertainty.degrees(index);
  LawFit neighbour = fit;
  const HeldCost cost = [&](double value) -> std::optional<double> {
    neighbour = held_at(problem, neighbour, index, value);
    const double least = neighbour.solution.cost;
    return std::isfinite(least) ? std::optional(least / unit) : std::nullopt;
  };
  return one_sided_limit(cost, search);
}

}  // namespace pliant
