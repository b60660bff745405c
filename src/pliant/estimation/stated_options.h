#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/fit_settings.h"

namespace pliant {

/// What a study says beforehand about what a fit is to find, in sentences for the report: stress
/// that never falls, fixed values, bounds, priors.
std::vector<std::string> stated_options(const FitOptions& options);

}  // namespace pliant
