#pragma once

#include <Eigen/Core>

namespace pliant {

/// Factors of the three components of bending that come nearest to a x = b, each between 0.01 and
/// 10. Hinges a hundred times softer than the sheet fold almost freely, and ten times stiffer ones
/// hardly bend: beyond, factors would change nothing but the conditioning.
/// @param a, b  a row for each direction of curvature
Eigen::Vector3d bounded_factors(const Eigen::Matrix<double, 4, 3>& a, const Eigen::Vector4d& b);

}  // namespace pliant
