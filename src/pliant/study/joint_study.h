#pragma once

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/study/study.h"
#include "pliant/study/study_fit_options.h"

namespace pliant {

/// Whether a study has experiments in one dimension to be fitted.
bool fits_strips(const Study& study);

/// Fits one material to sheets and to experiments in one dimension.
///
/// Each component that strips tell is fitted to them, its form included; then sheets are fitted by
/// their plan for what strips do not tell; and in the end everything together, each experiment
/// weighed by its own noise (`fit_jointly`). Where strips tell bending, the material bends as a
/// sheet does, whatever the meshes.
/// @throws InputError, SolverError, Interrupted
StudyResult fit_joint_study(const Study& study, const StudyFitOptions& options,
                            const RunContext& context);

}  // namespace pliant
