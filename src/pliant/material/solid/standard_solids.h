#pragma once

#include "pliant/material/material.h"

namespace pliant {

// Standard laws of solids as compositions of addends; numbers in Pa.

/// lambda / 2 tr(E)^2 + mu tr(E^2) ([T] Eq. 4.3).
Material stvk_solid(double lambda, double mu);

/// C10 (I1 J^(-2/3) - 3) + kappa / 2 (J - 1)^2: shear modulus 2 C10, bulk modulus kappa.
Material neo_hookean_solid(double c10, double kappa);

}  // namespace pliant
