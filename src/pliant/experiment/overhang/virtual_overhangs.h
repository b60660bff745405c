#pragma once

#include <string>

#include "pliant/base/random.h"
#include "pliant/experiment/lab_experiment.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// Pushes the strips of a virtual bending-length over the edge, both faces, each as often as it is
/// repeated: the table of their overhangs.
///
/// The strips are elasticas of more and shorter elements than those that a fit compares with.
/// @param law      of bending in the test's direction
/// @param density  kg/m^2, > 0
/// @throws SolverError when no overhang dips so far
std::string measure_overhangs(const LabExperiment& experiment, const ComponentLaw& law,
                              double density, RandomStream& random);

}  // namespace pliant
