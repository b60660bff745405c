#pragma once

#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/fit_settings.h"
#include "pliant/experiment/experiment.h"

namespace pliant {

/// Follows the stages that a study states for a solid ([T] 4.4: addends are estimated one after the
/// other, each from the examples that tell it). A stage looks for the numbers of its components in
/// its experiments. Components of earlier stages keep what these have found, those of later ones
/// are not there yet, but for what resists changes of volume, without which nothing would have one.
///
/// What is found is where the search for all numbers in all experiments begins.
/// @param material     at its starts; gets the numbers
/// @param experiments  that are fitted
/// @return what each stage has come to
/// @throws InputError where a stage names no component of the model, no experiment, or a component
///         that its experiments do not strain
std::vector<FitStage> follow_plan(const FitSettings& settings,
                                  const std::vector<const Experiment*>& experiments,
                                  const RunContext& context, Material& material);

}  // namespace pliant
