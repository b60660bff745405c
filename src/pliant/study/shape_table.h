#pragma once

#include <string>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// shapes/EXPERIMENT.csv: measured and predicted profiles of the experiment's strips, and the paths
/// of bending that their points took (docs/formats/results.md). The experiment has shapes.
std::string shape_table(const ExperimentResult& experiment);

}  // namespace pliant
