#pragma once

#include <memory>

#include "pliant/experiment/component_experiment.h"

namespace pliant {

/// The published estimator's prediction ([T] Eqs. 5.4, 5.5): the force of a law at the measured
/// strain, friction saturated at every turning point, its approximate solution. What it predicts of
/// a row is the measured value plus the error of the force (N, or N/m).
std::unique_ptr<Predictor> anchor_predictor(const ComponentExperiment& experiment,
                                            const ComponentLaw& law);

}  // namespace pliant
