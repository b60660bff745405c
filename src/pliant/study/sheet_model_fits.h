#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/study/sheet_models.h"

namespace pliant {

/// What came of the fit of one model in one variant.
struct ModelFit {
  ModelVariant combination;
  std::string failure;  ///< why there is no result; empty where there is one
  Study study;          ///< that was fitted
  StudyResult result;
};

/// Fits a study with one model and variant after the other, in the order of `model_variants`.
///
/// A fit also begins at the solutions of the largest variants that its own contains, and the best
/// is kept: no variant has a larger misfit than one that it contains. A fit that fails is told of,
/// and the others go on.
/// @param done  gets each as it ends
/// @throws InputError, SolverError of the first fit where none succeeds; Interrupted
void fit_sheet_models(const Study& study, const std::vector<ModelVariant>& combinations,
                      const RunContext& context, const std::function<void(const ModelFit&)>& done);

}  // namespace pliant
