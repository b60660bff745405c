#pragma once

#include <span>
#include <string>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/material/material.h"

namespace pliant {

/// Whether a component has numbers that may be used: it is there and not `unmeasured`.
bool is_known(const Material& material, const std::string& component);

/// The components that a cloth needs to move in space: stretch, shear and bending in all
/// directions.
const std::vector<std::string>& sheet_component_names();

/// Those that a sheet of a cloth takes: the six, and all that act on metrics (sheet_metric.h) or on
/// two strains.
std::vector<std::string> components_of_sheet(const Material& material);

/// The components that `filler` knows and `material` does not, in the order of their names in
/// `cloth_component_names`.
std::vector<std::string> fillable_components(const Material& material, const Material& filler);

/// A material whose unknown components are those of another one, with the status `assumed`; its
/// provenance says which, under `filled`. Nothing else is taken over.
/// @param where  of the filler, for messages
/// @throws InputError where the numbers of both are of different strains, so that they cannot stand
///         side by side
Material filled(const Material& material, const Material& filler, const Location& where = {});

/// @param names  the components that are needed
/// @param where  of the material, for the message
/// @throws InputError that names the components that are not known
void require_complete(const Material& material, std::span<const std::string> names,
                      const Location& where = {});

}  // namespace pliant
