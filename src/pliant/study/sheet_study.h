#pragma once

#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/sheet/sheet_problem.h"
#include "pliant/study/study.h"

namespace pliant {

/// Whether a study has sessions to be fitted.
bool fits_sheets(const Study& study);

/// Root mean square of the errors of the fitted experiments, each in per cent of its peak force or
/// its sheet's side: the number by which fits of the same experiments are compared.
double misfit_percent(const std::vector<ExperimentResult>& experiments);

/// A solution of a smaller variant of a study's model, where a fit may begin.
struct SheetStart {
  std::string variant;
  Material material;
  CordFrictions cords = {};
};

/// Fits a material to the sessions of a study, and predicts all of them with it.
/// @param starts  the fit begins at each of them, too; the best is kept, which may be a start as it
///                is
/// @throws InputError, SolverError, Interrupted
StudyResult fit_sheet_study(const Study& study, const RunContext& context,
                            const std::vector<SheetStart>& starts = {});

/// Adds the predictions of a study's sessions with a material to a result.
void evaluate_sheets(const Study& study, const Material& material, const RunContext& context,
                     StudyResult& result);

}  // namespace pliant
