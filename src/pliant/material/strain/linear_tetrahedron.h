#pragma once

#include "pliant/material/strain/green_strain.h"

namespace pliant {

/// A tetrahedron with linear shape functions: one point, of constant strain ([T] 4.2.6).
using LinearTetrahedron = GreenStrain<4>;

/// @param rest_positions  of the nodes (m); node 3 lies on the side of the triangle 0, 1, 2 to
///                        which its normal points
/// @throws AssertionError for a tetrahedron without volume or with reversed nodes
LinearTetrahedron::Rest tetrahedron_rest(const LinearTetrahedron::Positions& rest_positions);

/// Signed volume of a tetrahedron (m^3).
double tetrahedron_volume(const LinearTetrahedron::Positions& positions);

}  // namespace pliant
