#pragma once

#include "pliant/estimation/fit_settings.h"

namespace pliant {

/// The number of branches of friction grows in fits of one dimension alone.
/// @throws InputError where a study leaves it to the data
void require_stated_branches(const FitSettings& settings);

}  // namespace pliant
