#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/session.h"
#include "pliant/material/material.h"

namespace pliant::report {

/// Strains of one component of a material in elements of sheets.
struct ComponentStrains {
  std::string component;
  std::vector<double> strains;
};

/// The strains in all frames of sessions, element by element, as the measures of a material see
/// them.
/// @param material  that predicts the sessions
std::vector<ComponentStrains> sheet_strains(const std::vector<const Session*>& sessions,
                                            const Material& material);

}  // namespace pliant::report
