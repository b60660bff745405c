#pragma once

#include <vector>

#include "pliant/measurement/profile_rows.h"

namespace pliant {

/// Length (m) of a profile's line: of arcs through its points, which turn by what the lines between
/// the points do.
double arc_length(const ProfileRows& profile);

/// A profile's curvature: of the line of the strip's length, with a curvature that is a polynomial
/// of degree five piece by piece, that comes nearest to the points in the sense of least squares.
///
/// [P] 4.3 takes cubic splines through the points; between the few points of a tight spiral those
/// run too straight.
/// @param length  of the strip from its clamp to the last point (m)
/// @return 1/m, one for each point; positive where the profile turns left
std::vector<double> profile_curvature(const ProfileRows& profile, double length);

}  // namespace pliant
