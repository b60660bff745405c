#pragma once

#include <initializer_list>
#include <optional>

#include "pliant/solver/elastica/elastica.h"
#include "pliant/solver/elastica/strip_release.h"

namespace pliant {

/// How a strip hangs, on the line that it took.
struct HangingStrip {
  const Elastica& line;
  StripHistory history;
  StripShape shape;
};

/// Whether the points of a strip jump one by one when it is let go from a curvature (1/m).
bool snaps(const ComponentLaw& law, double curvature);

/// A strip that hangs from a clamp by one end: flat at first, bent to a cylinder and let go.
/// @param lines     of the strip, each finer than the one before; the next is taken where curvature
///                  jumps on one, and the last at once where the law snaps
/// @param rolled    curvature of the cylinder (1/m); 0: none
/// @param weight    per area (N/m^2)
/// @param accuracy  of the release (rad)
/// @return nothing where no equilibrium is found
std::optional<HangingStrip> hanging_strip(std::initializer_list<const Elastica*> lines,
                                          const ComponentLaw& law, double rolled, double weight,
                                          bool with_derivatives,
                                          double accuracy = kReleaseAccuracy);

}  // namespace pliant
