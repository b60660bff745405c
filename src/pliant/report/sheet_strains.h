#pragma once

#include <string>
#include <vector>

#include "pliant/material/material.h"
#include "pliant/measurement/session.h"

namespace pliant::report {

/// The strains of a component in all frames of a session, element by element, as the measures of a
/// material see them.
/// @param material  complete, with that component
std::vector<double> sheet_strains(const Session& session, const Material& material,
                                  const std::string& component);

}  // namespace pliant::report
