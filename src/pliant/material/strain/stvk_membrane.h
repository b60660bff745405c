#pragma once

#include "pliant/material/strain/membrane_rest.h"
#include "pliant/material/strain/strain_measure.h"

namespace pliant {

/// Green-Lagrange strains of a triangle ([T] Eq. 3.3): ((|w_u|^2 - 1) / 2, (|w_v|^2 - 1) / 2, w_u .
/// w_v).
struct StvkMembrane : StrainTypes<3, 3> {
  using Rest = MembraneRest;

  static Strain strain(const Rest& rest, const Positions& positions) {
    const Eigen::Matrix<double, 3, 2> w = positions * rest.weights;
    return {(w.col(0).squaredNorm() - 1) / 2, (w.col(1).squaredNorm() - 1) / 2,
            w.col(0).dot(w.col(1))};
  }

  static Gradient gradient(const Rest& rest, const Positions& positions) {
    const Eigen::Matrix<double, 3, 2> w = positions * rest.weights;
    Gradient result;
    for (int i = 0; i < 3; ++i) {
      const double u = rest.weights(i, 0), v = rest.weights(i, 1);
      result.template block<1, 3>(0, 3 * i) = u * w.col(0).transpose();
      result.template block<1, 3>(1, 3 * i) = v * w.col(1).transpose();
      result.template block<1, 3>(2, 3 * i) = (u * w.col(1) + v * w.col(0)).transpose();
    }
    return result;
  }

  /// The strains are quadratic: their Hessians are multiples of the identity, block by block.
  static Hessian weighted_hessian(const Rest& rest, const Positions&, const Strain& y) {
    return spread(rest, stress_matrix(y));
  }

  static Hessian convex_weighted_hessian(const Rest& rest, const Positions&, const Strain& y) {
    return spread(rest, positive_part(stress_matrix(y)));
  }

 private:
  static Eigen::Matrix2d stress_matrix(const Strain& y) {
    Eigen::Matrix2d stress;
    stress << y(0), y(2), y(2), y(1);
    return stress;
  }

  static Hessian spread(const Rest& rest, const Eigen::Matrix2d& stress) {
    const Eigen::Matrix3d blocks = rest.weights * stress * rest.weights.transpose();
    Hessian result = Hessian::Zero();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) result(3 * i + k, 3 * j + k) = blocks(i, j);
      }
    }
    return result;
  }
};

}  // namespace pliant
