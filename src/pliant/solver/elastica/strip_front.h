#pragma once

#include "pliant/solver/elastica/elastica.h"

namespace pliant {

/// Puts the fronts of a released strip where they belong between the points of its line.
///
/// Of a law that snaps on unloading (see snapping_strains) a strip keeps a curl where its moment
/// never fell below a limit, and is nearly flat elsewhere; its curvature jumps at the front between
/// them, which rests where the moment is at the limit. The points of a line snap one by one, so
/// that a release knows the front to a point and its derivatives do not know it at all. Here it is
/// moved to the limit, to first order, with what follows from that; the error is of second order in
/// the distance of the points.
///
/// A front that is farther from its limit than a point, as after a strip that swung back, stays.
/// @param ends    with a free far end; otherwise nothing is done
/// @param start   history before the release, the same at all points
/// @param before  history before the last step of the release, which ended at `shape`
/// @param shape   is changed where it jumps; its derivatives too, where it has them
void settle_fronts(const Elastica& strip, const ComponentLaw& law, double weight,
                   const StripEnds& ends, const StripHistory& start, const StripHistory& before,
                   StripShape& shape);

}  // namespace pliant
