#pragma once

#include <memory>

#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/material/material.h"

namespace pliant {

/// The experiment that a study describes.
/// @param data     its rows
/// @param density  kg/m^2; 0 = not stated
/// @throws InputError for unusable data; AssertionError for a type that is not supported
std::unique_ptr<ComponentExperiment> make_experiment(const ExperimentSpec& spec,
                                                     const DataRows& data, double density,
                                                     MembraneMeasure measure);

}  // namespace pliant
