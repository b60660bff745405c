#pragma once

#include <map>
#include <string>
#include <vector>

#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/unknown.h"
#include "pliant/material/material.h"

namespace pliant {

/// Components by name.
using KnownComponents = std::map<std::string, MaterialComponent>;

/// What a search begins with: one stiffness for each component, which may be one that the study
/// fixes, and the measures of a model. Its bending is that of a sheet where a known component
/// bends, else that of hinges.
/// @param known  components whose laws are known, and kept
Material first_sheet_material(const FitSettings& settings, const KnownComponents& known = {});

/// Stiffnesses that a search for bending may begin at, stiff ones first: soft sheets fold, and take
/// long. What bends diagonally is not far from what bends along the threads.
/// @param material  so far
std::vector<double> first_bending(const Material& material, const ComponentGroup& group);

}  // namespace pliant
