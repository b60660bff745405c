#pragma once

#include <span>
#include <string>
#include <vector>

#include "pliant/material/component_law.h"

namespace pliant {

/// Energies of a component's law at material points (J/m^2, of solids J/m^3), for the limits that
/// they may have.
/// @param strains  of the points, three each where the component acts on principal stretches
std::vector<double> energies_of_points(const std::string& component, const ComponentLaw& law,
                                       std::span<const double> strains);

}  // namespace pliant
