#pragma once

#include <Eigen/Core>

namespace pliant {

/// A triangle at rest in the plane of weft (u) and warp (v).
struct MembraneRest {
  /// w_u = positions * weights.col(0), w_v = positions * weights.col(1) ([T] Eq. 3.2); 1/m.
  Eigen::Matrix<double, 3, 2> weights;
  double area = 0;  ///< m^2
};

/// @param corners  rest-plane coordinates (m), one column a node, counter-clockwise
/// @throws AssertionError for a triangle without area or with reversed corners
MembraneRest membrane_rest(const Eigen::Matrix<double, 2, 3>& corners);

/// The nearest positive semidefinite matrix to a symmetric one.
Eigen::Matrix2d positive_part(const Eigen::Matrix2d& symmetric);

}  // namespace pliant
