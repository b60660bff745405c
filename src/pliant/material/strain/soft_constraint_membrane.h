#pragma once

#include "pliant/material/strain/membrane_rest.h"
#include "pliant/material/strain/strain_measure.h"

namespace pliant {

/// Strains of Baraff and Witkin's soft constraints on a triangle ([T] Eq. 3.4): (|w_u| - 1, |w_v| -
/// 1, w_u . w_v). Undefined where w_u or w_v vanishes.
struct SoftConstraintMembrane : StrainTypes<3, 3> {
  using Rest = MembraneRest;

  static Strain strain(const Rest& rest, const Positions& positions) {
    const Eigen::Matrix<double, 3, 2> w = positions * rest.weights;
    return {w.col(0).norm() - 1, w.col(1).norm() - 1, w.col(0).dot(w.col(1))};
  }

  static Gradient gradient(const Rest& rest, const Positions& positions) {
    const Eigen::Matrix<double, 3, 2> w = positions * rest.weights;
    const Eigen::Vector3d along_u = w.col(0).normalized(), along_v = w.col(1).normalized();
    Gradient result;
    for (int i = 0; i < 3; ++i) {
      const double u = rest.weights(i, 0), v = rest.weights(i, 1);
      result.template block<1, 3>(0, 3 * i) = u * along_u.transpose();
      result.template block<1, 3>(1, 3 * i) = v * along_v.transpose();
      result.template block<1, 3>(2, 3 * i) = (u * w.col(1) + v * w.col(0)).transpose();
    }
    return result;
  }

  static Hessian weighted_hessian(const Rest& rest, const Positions& positions, const Strain& y) {
    return spread(rest, positions, y.head<2>(), shear_matrix(y(2)));
  }

  static Hessian convex_weighted_hessian(const Rest& rest, const Positions& positions,
                                         const Strain& y) {
    return spread(rest, positions, y.head<2>().cwiseMax(0), positive_part(shear_matrix(y(2))));
  }

 private:
  static Eigen::Matrix2d shear_matrix(double stress) {
    Eigen::Matrix2d shear;
    shear << 0, stress, stress, 0;
    return shear;
  }

  static Hessian spread(const Rest& rest, const Positions& positions,
                        const Eigen::Vector2d& stretch, const Eigen::Matrix2d& shear) {
    const Eigen::Matrix<double, 3, 2> w = positions * rest.weights;
    const Eigen::Matrix3d u_part = stretch(0) * across(w.col(0));
    const Eigen::Matrix3d v_part = stretch(1) * across(w.col(1));
    const Eigen::Matrix3d shears = rest.weights * shear * rest.weights.transpose();
    Hessian result;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        result.template block<3, 3>(3 * i, 3 * j) =
            rest.weights(i, 0) * rest.weights(j, 0) * u_part +
            rest.weights(i, 1) * rest.weights(j, 1) * v_part +
            shears(i, j) * Eigen::Matrix3d::Identity();
      }
    }
    return result;
  }

  // Hessian of |w|: the projection across w, divided by its length.
  static Eigen::Matrix3d across(const Eigen::Vector3d& w) {
    const double length = w.norm();
    const Eigen::Vector3d along = w / length;
    return (Eigen::Matrix3d::Identity() - along * along.transpose()) / length;
  }
};

}  // namespace pliant
