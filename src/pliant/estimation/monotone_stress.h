#pragma once

#include <Eigen/Core>

#include "pliant/math/scalar_curve.h"

namespace pliant {

/// What makes the elastic stress k(strain) strain of a curve rise with strain, and its energy
/// convex: rows A such that none of A values is negative, each the tangent k + k' strain at one
/// strain. There are sixteen in each span of a Hermite curve.
/// @param largest_strain  up to which an affine stiffness is looked at
/// @return rows x control values; no rows where a stiffness that is not negative is enough
Eigen::MatrixXd elastic_tangents(const ScalarCurve& stiffness, double largest_strain);

}  // namespace pliant
