#pragma once

#include <vector>

#include "pliant/estimation/unknown.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// A law with its addends at all combinations of where fits of their kinds begin.
/// @param data  largest stress and strain, of which the beginnings are shares
std::vector<ComponentLaw> addend_starts(const ComponentLaw& law, const DataScale& data);

}  // namespace pliant
