#pragma once

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/study/study.h"

namespace pliant {

/// Whether a study's experiments are of solids.
bool measures_solids(const Study& study);

/// Whether the volume of a solid may change in some experiment.
bool is_compressible(const Study& study);

/// Fits a solid to all experiments of a study together, and predicts those that validate it.
/// @throws InputError for unusable data and models; SolverError, Interrupted
StudyResult fit_solid_study(const Study& study, const RunContext& context);

/// Predicts the experiments of a study with a solid.
/// @throws InputError for unusable data, or a material that is no solid
StudyResult evaluate_solid_study(const Study& study, const Material& material,
                                 const RunContext& context);

}  // namespace pliant
