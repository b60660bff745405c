#pragma once

#include <string>

#include "pliant/io/fields.h"
#include "pliant/material/material.h"

namespace pliant {

/// @param node  that names the component of a cloth
/// @throws InputError for one that is a function of Green's strain (`SheetMetric::of_any_strain`)
///         beside strains of another measure
void require_green_strain(const std::string& component, MembraneMeasure measure, const Value& node);

}  // namespace pliant
