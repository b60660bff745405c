#pragma once

namespace pliant {

/// An energy of a distance and its derivatives by it.
struct Barrier {
  double energy = 0;     ///< times a stiffness (N/m): J
  double slope = 0;      ///< <= 0; times it: N
  double curvature = 0;  ///< >= 0; times it: N/m
};

/// What keeps two surfaces apart: nothing from `thickness` on, (thickness - distance)^2 / 2 down to
/// half of it, and from there a logarithm that has no end. Twice continuously differentiable, and
/// convex.
/// @param distance   m, > 0
/// @param thickness  m, > 0
Barrier barrier(double distance, double thickness);

/// The distance that what goes a way towards something keeps from it: a share of the one it has, or
/// of half the thickness. Gaps below a ten-thousandth of the thickness hardly close any further:
/// rounding must not decide on which side a thing is.
/// @param distance  m, > 0
double distance_to_keep(double distance, double thickness, double share);

}  // namespace pliant
