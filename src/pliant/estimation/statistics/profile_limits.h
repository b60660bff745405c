#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace pliant {

/// Cost of the fit with the parameter held at a value and all others fitted again: half the sum of
/// squared residuals in units of sd sqrt(L), priors included. Nothing where the fit fails.
using HeldCost = std::function<std::optional<double>(double value)>;

/// Where a limit is looked for.
struct LimitSearch {
  double estimate = 0;
  double cost = 0;      ///< at the estimate
  double step = 0;      ///< away from the estimate, of either sign: about one standard error
  double farthest = 0;  ///< value beyond which no limit is of interest, on the side of `step`
  double degrees = 0;   ///< of freedom of the noise; infinite where it is stated
};

/// One-sided 95 % limit of a parameter whose estimate lies at its bound, away from the bound: where
/// the profile likelihood has risen by 2.71, the 90 % quantile of chi squared and 95 % quantile of
/// its mixture with zero ([Self1987]); with noise that was estimated, by the square of Student's
/// one-sided quantile.
///
/// A parameter's upper limit made like this holds in 95 to 100 % of all measurements, whatever the
/// true value. (Given only where the estimate is at its bound, and a two-sided interval elsewhere,
/// the pair holds in 92.5 % at the worst, 1.65 standard errors from the bound.)
/// @return nothing where the rise is not reached up to `farthest`, or a fit fails
std::optional<double> one_sided_limit(const HeldCost& cost, const LimitSearch& search);

/// Where a tabulated profile passes a threshold.
struct ProfileCrossings {
  std::optional<double> lower, upper;  ///< absent: not within the table
};

/// @param value     of the parameter, increasing
/// @param rise      2 (cost - least cost) at each value
/// @param estimate  index of the estimate, from which crossings are looked for outwards
/// @param threshold 3.84 for 95 %; between two values the root of the rise is a straight line
ProfileCrossings profile_crossings(const std::vector<double>& value,
                                   const std::vector<double>& rise, std::size_t estimate,
                                   double threshold);

}  // namespace pliant
