#pragma once

#include <string>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/solid/solid_fit.h"
#include "pliant/experiment/experiment.h"

namespace pliant {

/// An experiment of a solid as a material predicts it.
/// @throws SolverError where it has no prediction
ExperimentResult compare_solid(const Experiment& experiment, const Material& material);

/// Adds how far the prediction of an experiment may be off by the errors of the fitted numbers: its
/// 95 % band, row by row, and a sentence about it; or why nobody knows.
/// @param experiment  not fitted
/// @param result      of its comparison
void add_band(const SolidFit& fit, const Experiment& experiment, const RunContext& context,
              ExperimentResult& result);

/// Adds the numbers of a fit, its curves and what is to be said of it to the result of a study.
void add_solid_fit(const SolidFit& fit, StudyResult& result);

/// Adds the law of each component within the range of its data.
void add_solid_curves(const Material& material, const SolidFit* fit, StudyResult& result);

}  // namespace pliant
