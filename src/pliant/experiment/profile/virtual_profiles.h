#pragma once

#include <string>

#include "pliant/base/random.h"
#include "pliant/experiment/lab_experiment.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// Photographs the strips of a virtual cantilever or rolled-strip: the table of their profiles.
///
/// The strips are elasticas of more and shorter elements than those that a fit compares with. Their
/// points stand evenly along the strip; the first one, the clamp, is free of noise.
/// @param law      of bending in the test's direction
/// @param density  kg/m^2, > 0
/// @throws SolverError when a strip finds no equilibrium
std::string measure_profiles(const LabExperiment& experiment, const ComponentLaw& law,
                             double density, RandomStream& random);

}  // namespace pliant
