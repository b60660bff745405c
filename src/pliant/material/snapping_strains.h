#pragma once

#include <vector>

#include "pliant/material/component_law.h"

namespace pliant {

/// A range of |strain|; `to` may be infinite.
struct StrainInterval {
  double from = 0;
  double to = 0;
};

/// Strains at which the slope of the friction stress on unloading, at worst -b of all branches,
/// outweighs the elastic tangent k + k' strain: the law is not monotone there, and the material
/// itself snaps while it unloads.
/// @param side   1 or -1: the sign of the strains looked at
/// @param reach  |strain| up to which addends are looked at, whose curves say no end themselves
std::vector<StrainInterval> snapping_strains(const ComponentLaw& law, int side, double reach = 1);

}  // namespace pliant
