#include "pliant/solver/within_limits.h"

#include <algorithm>

#include "pliant/material/limit_barriers.h"

namespace pliant {

NewtonSummary minimize_within_limits(const System& system, const Conditions& under,
                                     const NewtonOptions& options, Workspace& workspace,
                                     Configuration& at, PhaseSeconds* seconds) {
  if (!system.is_limited()) {
    return minimize(Objective(system, under, seconds), options, workspace, at);
  }
  NewtonSummary summary;
  const auto follow = [&](const LimitBarrier& limits) {
    Conditions then = under;
    then.time.limits = limits;
    NewtonSummary found = minimize(Objective(system, then, seconds), options, workspace, at);
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
