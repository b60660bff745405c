#pragma once

#include "pliant/geometry/triangle_mesh.h"
#include "pliant/material/material.h"

namespace pliant::test {

/// A cylinder that a sheet is rolled to.
struct Cylinder {
  double curvature = 0;  ///< 1/m
  double direction = 0;  ///< of the curvature, angle from weft
};

/// Holds the two outermost rings of vertices of a flat mesh on a cylinder, lets those inside come
/// to equilibrium, and reads the stiffness k that the cloth shows from the energy per area
/// 3 k curvature^2 / 2 in the middle, out of reach of the rim.
/// @param material  linear: the stiffness of every component is constant
/// @return N m
double shown_stiffness(const TriangleMesh& mesh, const Material& material,
                       const Cylinder& cylinder);

}  // namespace pliant::test
