#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/hinge_direction.h"

namespace pliant {

/// Curvature directions in which the bending of a sheet is looked at, in the order of rows: weft,
/// warp, and 45 degrees between weft and warp, rising (u and v grow together) and falling.
enum CurvatureDirection { kAlongWeft, kAlongWarp, kAlongRising, kAlongFalling };

/// (kappa_uu, kappa_vv, kappa_uv) of a cylinder of curvature 1 in each direction, one a row.
inline Eigen::Matrix<double, 4, 3> cylinder_curvatures() {
  Eigen::Matrix<double, 4, 3> curvatures;
  curvatures << 1, 0, 0, 0, 1, 0, 0.5, 0.5, 0.5, 0.5, 0.5, -0.5;
  return curvatures;
}

/// How hinges add up to a sheet: rolled to a cylinder of curvature kappa in a direction (row), it
/// shows M/width = 3 (shares * hinge stiffness) kappa, columns in the order weft, warp, diagonal.
///
/// The sheet is relaxed: its mean curvature is that of the cylinder, its vertices stand where the
/// energy is least. The shares depend on the ratios of the stiffness therefore, and the product is
/// concave in the stiffness with the shares as its derivative.
using RigidityShares = Eigen::Matrix<double, 4, 3>;

/// Hinges that are alike, in a sheet that is bent to a cylinder of curvature 1 in each direction.
struct BentHinge {
  BendingVector parts;         ///< of the components in these hinges
  double area = 0;             ///< of the hinges, three times their fraction of the sheet's
  Eigen::RowVector4d bends{};  ///< dihedral angle over mean height, by CurvatureDirection
};

inline RigidityShares rigidity_shares(const std::vector<BentHinge>& hinges) {
  RigidityShares shares = RigidityShares::Zero();
  for (const BentHinge& hinge : hinges) {
    shares += hinge.area * hinge.bends.cwiseAbs2().transpose() * hinge.parts.transpose();
  }
  return shares;
}

}  // namespace pliant
