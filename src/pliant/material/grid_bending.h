#pragma once

#include <functional>
#include <vector>

#include "pliant/geometry/grid_pattern.h"
#include "pliant/geometry/hinge_direction.h"
#include "pliant/material/cylinder_rigidity.h"

namespace pliant {

/// Shares of the hinges in the bending of a large sheet of a regular pattern, from its periodic
/// cell.
///
/// With alternating diagonals the vertices where eight triangles meet and those where four meet
/// move apart in height: along weft and warp the sheet is softer than its hinges, by a factor 1 -
/// 0.5 / (1 + 2 r) for squares and r = diagonal / weft = diagonal / warp. With one diagonal
/// direction all vertices are alike and none moves.
/// @param hinge_stiffness  N m (or any unit: only ratios matter), >= 0, not all 0
RigidityShares grid_rigidity(const GridPattern& pattern, const BendingVector& hinge_stiffness);

/// Stress of hinges of a component at a strain (N): odd in the strain, not falling.
using HingeStress = std::function<double(int component, double strain)>;

/// The hinges of the cell, bent from flat to cylinders of a curvature under any law.
/// @param curvature  1/m, > 0; the bends are those over it
std::vector<BentHinge> bent_cell(const GridPattern& pattern, const HingeStress& stress,
                                 double curvature);

}  // namespace pliant
