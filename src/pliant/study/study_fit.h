#pragma once

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/study/study.h"
#include "pliant/study/study_fit_options.h"

namespace pliant {

/// Fits a material to a study: each component of strips from its own experiments, sheets by their
/// plan, and where there are both everything together in the end; then every experiment predicted,
/// the validation ones without any fitting.
/// @throws InputError for unusable data, or a study without an experiment that can be fitted;
/// Interrupted
StudyResult fit_study(const Study& study, const StudyFitOptions& options,
                      const RunContext& context);

}  // namespace pliant
