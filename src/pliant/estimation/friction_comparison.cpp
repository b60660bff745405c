#include "pliant/estimation/friction_comparison.h"

#include <algorithm>
#include <cstddef>

#include "pliant/estimation/experiment_result.h"
#include "pliant/estimation/statistics/model_ranking.h"

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

double worst_percent(const ComponentProblem& problem, const LawFit& fit) {
  double worst = 0;
  for (size_t e = 0; e < problem.experiments().size(); ++e) {
    const ComponentExperiment& experiment = *problem.experiments()[e];
    const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
    const ExperimentResult result =
        compare(experiment, fit.law, fit.nuisance.segment(problem.first_nuisance(e), count));
    worst = std::max(worst, result.rms_percent);
  }
  return worst;
}

}  // namespace

std::vector<ModelRank> compare_friction(const ComponentProblem& problem, const ComponentFit& fit,
                                        const ComponentPlan& plan) {
  std::vector<ModelRank> ranks;
  std::vector<RankedModel> models;
  for (const Candidate& candidate : candidates()) {
    if (!can_predict(problem, candidate.law)) continue;
    ComponentPlan own = plan;
    own.friction = candidate.law;
    if (candidate.constant_maximum) own.fit.fix[fit.component + ".friction.b"] = 0;
    const LawFit model = fit_form(problem, own).fit;
    ModelRank rank;
    rank.component = fit.component;
    rank.name = candidate.name;
    rank.parameters = free_count(model.unknowns);
    rank.rms_percent = worst_percent(problem, model);
    ranks.push_back(rank);
    models.push_back({2 * model.solution.cost / problem.used_rows(), rank.parameters});
  }
  const std::vector<ModelScore> scores =
      rank_models(models, effective_rows(fit.uncertainty.noise.of).effective);
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    ranks[i].aic = scores[i].aic;
    ranks[i].bic = scores[i].bic;
    ranks[i].delta_bic = scores[i].delta_bic;
  }
  std::sort(ranks.begin(), ranks.end(),
            [](const ModelRank& x, const ModelRank& y) { return x.bic < y.bic; });
  return ranks;
}

}  // namespace pliant
