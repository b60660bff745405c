#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/experiment/model_options.h"

namespace pliant {

/// Names of laws of solids that studies may ask for: neo-hookean, ..., additive.
std::vector<std::string_view> solid_laws();

/// The components of a solid's model: those that it states, else those of its law.
/// @param compressible  whether the data's volume may change: then something must resist that
std::map<std::string, ComponentModel> solid_components(const ModelOptions& model,
                                                       bool compressible);

}  // namespace pliant
