#pragma once

#include <optional>

#include "pliant/solver/elastica/elastica.h"

namespace pliant {

/// Angle (rad) to which a release that is not asked for more is followed: a hundredth of a
/// millimetre at the end of a strip of 100 mm.
inline constexpr double kReleaseAccuracy = 1e-4;

/// Takes away the moments that hold a strip in the shape of its history, all in one proportion,
/// until it hangs free.
///
/// Friction remembers where a point turned back. A step misses that for the points that turn within
/// it, so steps are halved until two halves end where the whole does; where the strip snaps over,
/// no step is small enough, and the smallest is taken.
/// @param accuracy  greatest difference between a whole step and its halves, of the angle by which
///                  the strip has turned anywhere (rad)
/// @param history   gets what the material remembers at the end
/// @return nothing when there is no equilibrium nearby
std::optional<StripShape> released(const Elastica& strip, const ComponentLaw& law, double weight,
                                   const StripEnds& ends, bool with_derivatives,
                                   StripHistory& history, double accuracy = kReleaseAccuracy);

}  // namespace pliant
