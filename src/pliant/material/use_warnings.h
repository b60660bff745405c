#pragma once

#include <span>
#include <string>
#include <vector>

#include "pliant/material/material.h"

namespace pliant {

/// What a simulation accepts of a material, but its user should know: a density that no cloth has,
/// measured components that it does not use, and
/// those that it uses although no data determined them.
/// @param used  the components that it uses
std::vector<std::string> use_warnings(const Material& material, std::span<const std::string> used);

/// Components among those used whose stiffness or friction the fit that measured them calls not
/// determined, with what it knows of their numbers.
std::vector<std::string> undetermined_warnings(const Material& material,
                                               std::span<const std::string> used);

}  // namespace pliant
