#pragma once

#include <span>
#include <string>
#include <vector>

#include "pliant/material/material.h"

namespace pliant {

/// What a simulation accepts of a material, but its user should know: a density that no cloth has,
/// and measured components that it does not use.
/// @param used  the components that it uses
std::vector<std::string> use_warnings(const Material& material, std::span<const std::string> used);

}  // namespace pliant
