#pragma once

#include <optional>
#include <string>

#include "pliant/material/material.h"
#include "pliant/study/results.h"

namespace pliant::report {

/// The material at a glance, in a laboratory's units: of each component stiffness, friction and the
/// figures that its tests are known for, with their standard errors, and the range of the data.
/// @param material  the fitted one, which tells the range where no experiment does
std::string material_table(const Results& results, const std::optional<Material>& material = {});

}  // namespace pliant::report
