#pragma once

#include <map>
#include <string>
#include <vector>

#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/system.h"

namespace pliant {

/// Fields of elements as means at vertices, weighted by the elements' rest measures; 0 where no
/// element has the field.
/// @param first_point, vertices  the points of the cloth
/// @return by the names of ElementFields::field_names, one number a vertex
std::map<std::string, Eigen::VectorXd> vertex_fields(const System& system, const State& state,
                                                     const std::vector<ShownPotential>& shown,
                                                     int first_point, int vertices);

}  // namespace pliant
