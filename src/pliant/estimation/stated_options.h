#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/fit_settings.h"

namespace pliant {

/// What a study says beforehand about what a fit is to find, in sentences for the report: stress
/// that never falls, fixed values, bounds, priors.
std::vector<std::string> stated_options(const FitOptions& options);

/// Sentences on bounds, fixed values and priors that match no parameter.
/// @param names  of all parameters and nuisances of a fit
std::vector<std::string> unmatched_options(const FitOptions& options,
                                           const std::vector<std::string>& names);

}  // namespace pliant
