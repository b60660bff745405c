#pragma once

#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/component_work.h"
#include "pliant/study/study_experiments.h"
#include "pliant/study/study_fit_options.h"

namespace pliant {

/// Fits each component of a study to its own experiments in one dimension, side by side.
/// @param result  gets a warning of components that nothing is fitted to, and what they leave
///                undetermined
/// @throws InputError for options that do not go with the experiments; Interrupted
std::vector<ComponentWork> fit_components(const FitSettings& settings,
                                          const Experiments& experiments,
                                          const StudyFitOptions& options, const RunContext& context,
                                          StudyResult& result);

}  // namespace pliant
