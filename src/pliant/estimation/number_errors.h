#pragma once

#include <vector>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Gives the measured components of a material what a fit knows of the errors of their numbers;
/// numbers that the study fixed have none.
/// @param isotropic  weft and warp share their laws: both get the errors of weft
void state_errors(const std::vector<ParameterEstimate>& parameters, bool isotropic,
                  Material& material);

}  // namespace pliant
