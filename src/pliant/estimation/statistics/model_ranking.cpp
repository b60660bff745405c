#include "pliant/estimation/statistics/model_ranking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {

std::vector<ModelScore> rank_models(const std::vector<RankedModel>& models, double effective_rows) {
  const double rows = std::max(effective_rows, 1.0);
  std::vector<ModelScore> scores;
  double best = std::numeric_limits<double>::infinity();
  for (const RankedModel& model : models) {
    const double misfit = rows * std::log(model.mean_square);
    scores.push_back({misfit + 2 * model.parameters, misfit + std::log(rows) * model.parameters});
    best = std::min(best, scores.back().bic);
  }
  for (ModelScore& score : scores) score.delta_bic = score.bic - best;
  return scores;
}

}  // namespace pliant
