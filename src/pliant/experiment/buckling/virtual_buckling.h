#pragma once

#include <string>

#include "pliant/base/random.h"
#include "pliant/experiment/lab_experiment.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// The measurement of a virtual buckling-bend as a CSV table.
/// @param density  kg/m^2
/// @throws SolverError when the strip finds no equilibrium
std::string measure_buckling(const LabExperiment& experiment, const ComponentLaw& law,
                             double density, RandomStream& random);

}  // namespace pliant
