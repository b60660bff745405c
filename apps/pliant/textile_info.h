#pragma once

#include <nlohmann/json.hpp>

#include "pliant/material/material.h"

#include "apps/pliant/file_info.h"

namespace pliant {

/// Adds what textile instruments would read of a component. Stretch and shear: secant moduli and
/// the width of the loop (estimation/lab_figures.h). Bending (docs/bending.md): B and 2HB of
/// KES-FB2, and the bending length where the density is known.
/// @param name  of a component whose stiffness is given, that of bending being of a sheet
/// @return the same for the summary, SI and the instruments' units
Json textile_info(const Material& material, const std::string& name, FileInfo& info);

}  // namespace pliant
