#pragma once

#include <vector>

namespace pliant {

/// Information criteria of a model, up to what all models of the same rows share.
struct ModelScore {
  double aic = 0;
  double bic = 0;
  double delta_bic = 0;  ///< above the best of those ranked
};

/// A model to be ranked.
struct RankedModel {
  double mean_square = 0;  ///< of the weighted residuals, over the same rows for all; > 0
  int parameters = 0;
};

/// Scores in the order of the models: n log(mean square) + 2 p and n log(mean square) + p log(n)
/// ([Akaike1974], [Schwarz1978]).
/// @param effective_rows  sum of rows / L of one of the models (the richest): rows whose residuals
/// go together count as one; less than 1 counts as 1
std::vector<ModelScore> rank_models(const std::vector<RankedModel>& models, double effective_rows);

}  // namespace pliant
