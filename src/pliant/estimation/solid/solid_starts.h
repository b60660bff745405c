#pragma once

#include <map>
#include <string>
#include <vector>

#include "pliant/estimation/solid/solid_problem.h"
#include "pliant/experiment/model_options.h"

namespace pliant {

/// A material in the form of a model, at each combination of where the numbers of its laws begin;
/// spline energies with one control point, at rest.
/// @throws InputError for a component of which the data show nothing
std::vector<Material> solid_starts(const FitSettings& settings,
                                   const std::map<std::string, ComponentModel>& components,
                                   SolidProblem& problem);

}  // namespace pliant
