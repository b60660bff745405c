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

}  // namespace pliant
