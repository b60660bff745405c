#include "pliant/solver/within_limits.h"

#include <array>

namespace pliant {
namespace {

// Barriers of a search that comes back from beyond a limit: the multipliers that they can hold
// there grow from one to the next.
constexpr std::array kMended{1e-1, 1e-2, 1e-3, 1e-4};
constexpr std::array kBarriers{1e-2, 1e-4};

class LimitSearch {
 public:
  LimitSearch(const System& system, const Conditions& under, const NewtonOptions& options,
              Workspace& workspace, PhaseSeconds* seconds)
      : system_(system),
        under_(under),
        options_(options),
        workspace_(workspace),
        seconds_(seconds) {}

  NewtonSummary run(Configuration& at) {
    if (system_.share_left(at, under_) <= 0 && !come_back(at)) return summary_;
    for (const double barrier : kBarriers) step({.share = barrier}, at);
    step(LimitBarrier{}, at);
    return summary_;
  }

 private:
  bool come_back(Configuration& at) {
    for (const double mended : kMended) {
      step({.share = kBarriers.front(), .mended = mended}, at);
      if (system_.share_left(at, under_) > 0) return true;
    }
    summary_.converged = false;
    return false;
  }

  void step(const LimitBarrier& limits, Configuration& at) {
    Conditions under = under_;
    under.time.limits = limits;
    NewtonSummary found = minimize(Objective(system_, under, seconds_), options_, workspace_, at);
    found.iterations += summary_.iterations;
    found.factorizations += summary_.factorizations;
    found.linear_iterations += summary_.linear_iterations;
    summary_ = found;
  }

  const System& system_;
  const Conditions& under_;
  const NewtonOptions& options_;
  Workspace& workspace_;
  PhaseSeconds* seconds_;
  NewtonSummary summary_;
};

}  // namespace

NewtonSummary minimize_within_limits(const System& system, const Conditions& under,
                                     const NewtonOptions& options, Workspace& workspace,
                                     Configuration& at, PhaseSeconds* seconds) {
  if (!system.is_limited()) {
    return minimize(Objective(system, under, seconds), options, workspace, at);
  }
  return LimitSearch(system, under, options, workspace, seconds).run(at);
}

}  // namespace pliant
