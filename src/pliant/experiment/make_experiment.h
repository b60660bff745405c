#pragma once

#include <memory>
#include <vector>

#include "pliant/experiment/experiment.h"
#include "pliant/experiment/study.h"

namespace pliant {

/// The experiment that a study describes, its data read.
/// @param density  kg/m^2; 0 = not stated
/// @throws InputError for unusable data; AssertionError for a type that is not supported
std::unique_ptr<Experiment> make_experiment(const ExperimentSpec& spec, double density,
                                            MembraneMeasure measure);

}  // namespace pliant
