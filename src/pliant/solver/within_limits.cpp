#include "pliant/solver/within_limits.h"

#include <algorithm>

#include "pliant/material/limit_barriers.h"

namespace pliant {
namespace {

/// Of the largest force that holds the points: less is rounding, as a limit that is nearly reached
/// makes forces of differences of energies that differ in their last digits.
constexpr double kBalance = 1e-6;

}  // namespace

NewtonSummary minimize_within_limits(const System& system, const Conditions& under,
                                     const NewtonOptions& options, Workspace& workspace,
                                     Configuration& at) {
  if (!system.is_limited()) {
    return minimize(Objective(system, under), options, workspace, at);
  }
  NewtonSummary summary;
  double held_with = 0;  // N
  const auto follow = [&](const LimitBarrier& limits) {
    Conditions then = under;
    then.time.limits = limits;
    const Objective objective(system, then);
    NewtonOptions own = options;
    own.tolerance = std::max(own.tolerance, kBalance * held_with);
    NewtonSummary found = minimize(objective, own, workspace, at);
    held_with = objective.gradient(at).colwise().norm().maxCoeff();
    found.iterations += summary.iterations;
    found.factorizations += summary.factorizations;
    found.linear_iterations += summary.linear_iterations;
    summary = found;
    return found.converged;
  };
  if (std::ranges::all_of(kLimitBarriers, follow)) {
    summary.converged = system.share_left(at, under) > 0 && follow({});
  }
  return summary;
}

}  // namespace pliant
