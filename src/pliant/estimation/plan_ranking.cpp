#include "pliant/estimation/plan_ranking.h"

#include <algorithm>
#include <cstddef>

#include "pliant/estimation/experiment_result.h"
#include "pliant/estimation/statistics/model_ranking.h"

namespace pliant {
namespace {

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

std::vector<ModelRank> rank_plans(const ComponentProblem& problem, const ComponentFit& fit,
                                  const std::vector<RivalPlan>& rivals) {
  std::vector<ModelRank> ranks;
  std::vector<RankedModel> models;
  for (const RivalPlan& rival : rivals) {
    const LawFit model = fit_form(problem, rival.plan).fit;
    ModelRank rank;
    rank.component = fit.component;
    rank.name = rival.name;
    rank.told_by = rival.told_by;
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
