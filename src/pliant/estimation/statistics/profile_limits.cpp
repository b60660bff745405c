#include "pliant/estimation/statistics/profile_limits.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/tools/roots.hpp>

#include "pliant/base/assert.h"
#include "pliant/math/quantiles.h"

namespace pliant {
namespace {

constexpr double kTolerance = 1e-3;  // of the distance from the estimate: fits are no more exact
constexpr int kMostSteps = 60;       // of doubled length
constexpr std::uintmax_t kMostFits = 30;

/// Root of the rise in standard errors, less the limit's. The root is nearly a straight line.
class Excess {
 public:
  Excess(const HeldCost& cost, double least, double quantile)
      : cost_(cost), least_(least), quantile_(quantile) {}

  /// Where a fit fails: zero, which ends a search; `failed` says so.
  double operator()(double value) {
    const auto cost = cost_(value);
    failed_ = failed_ || !cost;
    return cost ? std::sqrt(std::max(2 * (*cost - least_), 0.0)) - quantile_ : 0;
  }
  bool failed() const { return failed_; }

 private:
  const HeldCost& cost_;
  double least_, quantile_;
  bool failed_ = false;
};

std::optional<double> limit(const HeldCost& cost, const LimitSearch& search, double quantile) {
  PLIANT_ASSERT(search.step != 0, "a limit is looked for on one side");
  Excess excess(cost, search.cost, quantile);
  const auto within = [&](double value) {
    return search.step > 0 ? std::min(value, search.farthest) : std::max(value, search.farthest);
  };
  double near = search.estimate, f_near = -quantile, step = search.step;
  for (int i = 0; i < kMostSteps; ++i, step *= 2) {
    const double far = within(near + step);
    if (far == near) return std::nullopt;
    const double f_far = excess(far);
    if (excess.failed()) return std::nullopt;
    if (f_far == 0) return far;
    if (f_far < 0) {
      near = far;
      f_near = f_far;
      continue;
    }
    const auto settled = [&](double a, double b) {
      return std::abs(b - a) < kTolerance * std::abs((a + b) / 2 - search.estimate);
    };
    std::uintmax_t fits = kMostFits;
    const bool rising = far > near;
    const auto bracket = boost::math::tools::toms748_solve(
        [&](double value) { return excess(value); }, rising ? near : far, rising ? far : near,
        rising ? f_near : f_far, rising ? f_far : f_near, settled, fits);
    if (excess.failed()) return std::nullopt;
    return (bracket.first + bracket.second) / 2;
  }
  return std::nullopt;
}

std::optional<double> crossing(const std::vector<double>& value, const std::vector<double>& rise,
                               std::size_t from, int direction, double threshold) {
  for (auto i = static_cast<std::ptrdiff_t>(from);; i += direction) {
    const auto next = i + direction;
    if (next < 0 || next >= static_cast<std::ptrdiff_t>(value.size())) return std::nullopt;
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(next);
    if (rise[b] < threshold) continue;
    const double low = std::sqrt(std::clamp(rise[a], 0.0, threshold));
    const double high = std::sqrt(rise[b]);
    const double share = high > low ? (std::sqrt(threshold) - low) / (high - low) : 1;
    return value[a] + share * (value[b] - value[a]);
  }
}

}  // namespace

std::optional<double> one_sided_limit(const HeldCost& cost, const LimitSearch& search) {
  return limit(cost, search, one_sided_student_quantile_95(search.degrees));
}

ProfileCrossings profile_crossings(const std::vector<double>& value,
                                   const std::vector<double>& rise, std::size_t estimate,
                                   double threshold) {
  PLIANT_ASSERT(value.size() == rise.size() && estimate < value.size(),
                "the estimate is one of the values");
  return {crossing(value, rise, estimate, -1, threshold),
          crossing(value, rise, estimate, 1, threshold)};
}

}  // namespace pliant
