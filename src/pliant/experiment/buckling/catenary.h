#pragma once

namespace pliant {

/// Pull at the ends of a strip that has weight and no stiffness and hangs between two points of one
/// height: H with L = (2 H / w) sinh(w d / (2 H)), the catenary.
/// @param weight    w, per area (N/m^2), > 0
/// @param length    L of the strip (m)
/// @param distance  d of its ends (m), 0 < d < L
/// @return per width (N/m)
double catenary_pull(double weight, double length, double distance);

}  // namespace pliant
