#pragma once

#include <cmath>

#include "pliant/material/strain/strain_measure.h"

namespace pliant {

/// Relative change of the distance of two nodes ([T] Eq. 3.1): l / l0 - 1. Ring-1 springs measure
/// stretch and shear, ring-2 springs bending. Undefined where the nodes meet.
struct Spring : StrainTypes<2, 1> {
  struct Rest {
    double length = 0;  ///< l0, m
  };

  static Strain strain(const Rest& rest, const Positions& positions) {
    return Strain((positions.col(1) - positions.col(0)).norm() / rest.length - 1);
  }

  static Gradient gradient(const Rest& rest, const Positions& positions) {
    const Eigen::Vector3d along = (positions.col(1) - positions.col(0)).normalized() / rest.length;
    Gradient result;
    result << -along.transpose(), along.transpose();
    return result;
  }

  static Hessian weighted_hessian(const Rest& rest, const Positions& positions, const Strain& y) {
    const Eigen::Vector3d edge = positions.col(1) - positions.col(0);
    const double length = edge.norm();
    const Eigen::Vector3d along = edge / length;
    const Eigen::Matrix3d block =
        y(0) / (rest.length * length) * (Eigen::Matrix3d::Identity() - along * along.transpose());
    Hessian result;
    result << block, -block, -block, block;
    return result;
  }

  static Hessian convex_weighted_hessian(const Rest& rest, const Positions& positions,
                                         const Strain& y) {
    return weighted_hessian(rest, positions, y.cwiseMax(0));
  }
};

}  // namespace pliant
