#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "pliant/material/material.h"

#include "apps/pliant/file_info.h"

namespace pliant {

/// Tells whether the energy of a component, which has a law, is convex in its strain over its
/// range; of a term of two strains, whether all that the material has in these two is convex in
/// them.
/// @param json  of the component: gets `convex` and `concave`
void add_convexity(const Material& material, const std::string& component, FileInfo& info,
                   Json& json);

}  // namespace pliant
