#pragma once

#include "pliant/exchange/keyword_material.h"

namespace pliant {

/// A keyword file (.inp) of Abaqus or CalculiX in SI units: the material, to be included; or, with
/// a mesh, a model to which supports and steps are added: nodes and elements in the order of the
/// mesh from 1 on, a section of all elements, sets of its groups and of its regions.
/// @throws InputError, with the field, for a law that the tool does not have
ConvertedSolid keyword_file(const SolidToConvert& solid, KeywordTool tool);

}  // namespace pliant
