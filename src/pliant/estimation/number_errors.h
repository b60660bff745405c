#pragma once

#include <vector>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// Gives the measured components of a material what a fit knows of the errors of their numbers;
/// numbers that the study fixed have none. Where weft and warp share a law, both get those of weft.
void state_errors(const std::vector<ParameterEstimate>& parameters, Material& material);

}  // namespace pliant
