#pragma once

#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_settings.h"
#include "pliant/experiment/experiment.h"
#include "pliant/material/material.h"

namespace pliant {

/// Share of the weighed squares about the mean of each experiment that a prediction explains; 1 at
/// best.
double explained_share(const std::vector<const Experiment*>& experiments, const Material& material);

/// Asks whether the stresses of the experiments are true ones, force over the area as it is, where
/// they exceed the law most where the stretch is largest, as those would, and a law of the same
/// form meets them much better as such.
/// @param material  fitted to them as nominal ones
std::vector<std::string> true_stress_questions(const FitSettings& settings,
                                               const Material& material,
                                               const std::vector<const Experiment*>& experiments,
                                               const RunContext& context);

}  // namespace pliant
