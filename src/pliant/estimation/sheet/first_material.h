#pragma once

#include <map>
#include <string>

#include "pliant/estimation/fit_settings.h"
#include "pliant/material/material.h"

namespace pliant {

/// Components by name.
using KnownComponents = std::map<std::string, MaterialComponent>;

/// What a search begins with: one stiffness for each component, which may be one that the study
/// fixes, and the measures of a model. Its bending is that of a sheet where a known component
/// bends, else that of hinges.
/// @param known  components whose laws are known, and kept
Material first_sheet_material(const FitSettings& settings, const KnownComponents& known = {});

}  // namespace pliant
