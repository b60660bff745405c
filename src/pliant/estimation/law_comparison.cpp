#include "pliant/estimation/law_comparison.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/estimation/plan_ranking.h"
#include "pliant/experiment/loop_metrics.h"
#include "pliant/experiment/row_times.h"
#include "pliant/material/addend/addend_registry.h"

namespace pliant {
namespace {

constexpr const char* kAsFitted = "as fitted";
constexpr const char* kForgets = "nothing that remembers";
constexpr double kClear = 10;  // of the BIC: very strong evidence (Kass and Raftery 1995)

/// A further law, and the test that tells it from others.
struct Candidate {
  const char* kind;
  const char* told_by;
};

constexpr Candidate kCandidates[] = {
    {"dahl", "small cycles within large ones"},
    {"softening", "cycles that grow, each pulled again to the strain of the one before"},
    {"set", "the strain that is left after cycles that grow"},
    {"maxwell", "the same cycle at another speed, or held strains"},
    {"rate-friction", "the same cycle at two speeds more, a decade apart"},
};

bool have_times(const ComponentProblem& problem) {
  return std::ranges::all_of(problem.experiments(), [](const ComponentExperiment* experiment) {
    return has_times(*experiment);
  });
}

bool may_remember(const ComponentProblem& problem) {
  return std::ranges::none_of(problem.experiments(), [](const ComponentExperiment* experiment) {
    return experiment->info().test.needs_density;
  });
}

}  // namespace

std::vector<ModelRank> compare_laws(const ComponentProblem& problem, const ComponentFit& fit,
                                    const ComponentPlan& plan) {
  if (!may_remember(problem)) return {};
  std::vector<RivalPlan> rivals{{kAsFitted, plan}};
  ComponentPlan forgets = plan;
  forgets.friction = FrictionLaw::none;
  std::erase_if(forgets.addends, [](const AddendKind* kind) { return remembers(*kind); });
  if (plan.form().remembers()) rivals.push_back({kForgets, forgets});
  const bool turns = any_unloads(problem.experiments()), timed = have_times(problem);
  for (const Candidate& candidate : kCandidates) {
    const AddendKind* kind = find_addend_kind(candidate.kind);
    if (kind->flows ? !timed : !turns) continue;
    ComponentPlan with = plan;
    with.addends.push_back(kind);
    rivals.push_back({fmt::format("with {}", candidate.kind), with, candidate.told_by});
  }
  return rank_plans(problem, fit, rivals);
}

std::vector<std::string> law_advice(const std::vector<ModelRank>& ranks) {
  const auto own = std::ranges::find(ranks, kAsFitted, &ModelRank::name);
  if (own == ranks.end()) return {};
  std::vector<std::string> advice;
  const ModelRank& best = ranks.front();
  if (own->delta_bic > kClear) {
    advice.push_back(fmt::format(
        "{}: the data ask for another law: {} leaves {:.2g} % of the peak where the one that was "
        "fitted leaves {:.2g} % (BIC {:.0f} lower)",
        best.component, best.name, best.rms_percent, own->rms_percent, own->delta_bic));
  }
  std::vector<std::string> alike, tests;
  for (const ModelRank& rank : ranks) {
    if (rank.delta_bic > kClear) continue;
    alike.push_back(rank.name);
    if (!rank.told_by.empty()) tests.push_back(rank.told_by);
  }
  if (alike.size() > 1 && !tests.empty()) {
    advice.push_back(fmt::format("{}: the data hardly tell apart: {}; what would: {}",
                                 best.component, fmt::join(alike, ", "), fmt::join(tests, "; ")));
  }
  return advice;
}

}  // namespace pliant
