#pragma once

#include <string>
#include <vector>

#include "pliant/material/material.h"

namespace pliant {

/// How far a solid was deformed in one way, and what was seen on that way.
struct EllipticRange {
  std::string way;          ///< "uniaxial", ..., "shear"
  bool compressed = false;  ///< a stretch below 1, or the other sign of a shear
  double reach = 1;         ///< the last stretch (shear: angle's tangent) that was looked at
  bool lost = false;        ///< whether strong ellipticity ends before
  double at = 0;            ///< the stretch or shear from which on it is lost
  bool limited = false;     ///< a limit of energy ends the way at `reach`
};

/// Follows a solid from rest along uniaxial, equibiaxial, planar and volumetric stretches and
/// simple shear, in both signs, and looks for where strong ellipticity is lost (ellipticity.h).
/// Stretches across are those of least energy, as in homogeneous tests; a material that nothing but
/// its shape is known of keeps its volume, and is not looked at where that changes. Friction is
/// left out.
std::vector<EllipticRange> elliptic_ranges(const Material& material);

}  // namespace pliant
