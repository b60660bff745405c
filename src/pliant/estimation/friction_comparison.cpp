#include "pliant/estimation/friction_comparison.h"

#include <algorithm>
#include <utility>

#include "pliant/estimation/plan_ranking.h"

namespace pliant {
namespace {

struct Candidate {
  std::string name;
  FrictionLaw law;
  bool constant_maximum;
};

const std::vector<Candidate>& candidates() {
  static const std::vector<Candidate> all{
      {"linear maximum, constant tau", FrictionLaw::dahl, false},
      {"constant maximum, constant tau", FrictionLaw::dahl, true},
      {"linear maximum, constant alpha", FrictionLaw::constant_slope, false},
      {"no friction", FrictionLaw::none, false},
  };
  return all;
}

// The shape of a strip is where its energy is least; none is known of friction with constant alpha.
bool can_predict(const ComponentProblem& problem, FrictionLaw law) {
  const auto& experiments = problem.experiments();
  const bool shaped = std::any_of(experiments.begin(), experiments.end(),
                                  [](const auto* e) { return e->info().test.needs_density; });
  return law != FrictionLaw::constant_slope || !shaped;
}

}  // namespace

std::vector<ModelRank> compare_friction(const ComponentProblem& problem, const ComponentFit& fit,
                                        const ComponentPlan& plan) {
  std::vector<RivalPlan> rivals;
  for (const Candidate& candidate : candidates()) {
    if (!can_predict(problem, candidate.law)) continue;
    ComponentPlan own = plan;
    own.friction = candidate.law;
    if (candidate.constant_maximum) own.fit.fix[fit.component + ".friction.b"] = 0;
    rivals.push_back({candidate.name, std::move(own)});
  }
  return rank_plans(problem, fit, rivals);
}

}  // namespace pliant
