#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/hinges.h"

namespace pliant {

/// One number for each component of bending, in the order weft, warp, diagonal.
using BendingVector = Eigen::Vector3d;

/// Angle between the direction in which a hinge curves the sheet, across its edge, and the weft
/// axis; in [0, pi/2], because angles that mirror each other at weft or warp are the same to an
/// orthotropic sheet. 0: edge parallel to v, bends weft; pi/2: edge parallel to u, bends warp.
/// @param rest_edge  the hinge's edge in the rest plane, of any length
double curvature_angle(const Eigen::Vector2d& rest_edge);

/// Parts that the bending components have in a hinge of a mesh cut from rectangles: one component
/// each. Edges parallel to v bend weft, those parallel to u bend warp, and the diagonals of the
/// rectangles bend diagonally, whatever their angle.
BendingVector class_weights(double curvature_angle);

/// Parts that the bending components have in a hinge of an irregular mesh.
///
/// With c = cos 2 angle: c^2 weft (below pi/4) or warp (above), and 1 - c^2 diagonal. Exactly one
/// component at 0, pi/4 and pi/2, smooth, the sum is 1 and no part is ever negative, so that a
/// hinge's energy is convex where those of the components are. The trigonometric polynomial through
/// the same three values is negative between them. With linear parts the bending across the
/// diagonals of a mesh could not be made as soft as an orthotropic sheet can be.
BendingVector interpolated_weights(double curvature_angle);

/// Which of the two holds for the hinges of a mesh.
enum class BendingRule { by_class, interpolated };

/// By class where every triangle is half of a rectangle along weft and warp, interpolated
/// elsewhere.
BendingRule bending_rule(const TriangleMesh& mesh);

/// The parts of all hinges.
/// @param hinges  a hinge across a seam counts in the rest plane of its first triangle
std::vector<BendingVector> bending_weights(const std::vector<Hinge>& hinges, BendingRule rule);

}  // namespace pliant
