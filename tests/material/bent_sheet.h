#pragma once

#include "pliant/geometry/hinge_direction.h"
#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// A sheet rolled to a cylinder, for measuring the bending stiffness that it shows.
struct BentSheet {
  BendingVector hinge_stiffness;  ///< N m
  double membrane_stiffness = 0;  ///< N/m, of all strains
  double curvature = 0;           ///< 1/m
  double direction = 0;           ///< of the curvature, angle from weft
};

/// Holds the two outermost rings of vertices of a flat mesh on a cylinder, lets those inside come
/// to the equilibrium of discrete shells and StVK membrane in space, and reads the stiffness k from
/// the energy per area 3 k curvature^2 / 2 in the middle, out of reach of the rim.
/// @return N m
double shown_stiffness(const TriangleMesh& mesh, const BentSheet& sheet);

}  // namespace pliant
