#pragma once

#include <Eigen/Core>

#include "pliant/material/density/density.h"

namespace pliant {

/// What a law answers at a deformed point that remembers nothing.
struct DeformedPoint {
  Eigen::Matrix3d gradient;             ///< deformation gradient F
  double energy = 0;                    ///< J/m^3; infinite beyond a limit
  Eigen::Matrix<double, 6, 1> stress;   ///< second Piola-Kirchhoff (Pa), as `kSolidStrains`
  Eigen::Matrix<double, 6, 6> tangent;  ///< d stress / d Green strain (Pa)
};

/// @param law  on six strains
DeformedPoint deformed_point(const Density& law, const Eigen::Matrix3d& gradient);

/// The least eigenvalue of the acoustic tensor Q_ik = n_J n_L dP_iJ / dF_kL over the directions n
/// at rest (Pa): density times the square of the slowest wave's speed. Strong ellipticity holds
/// where it is above 0; where it is not, the deformation may concentrate in bands across n
/// ([MarsdenHughes1983] 3.4).
/// @param isochoric  the volume stays: waves whose motion lies across the deformed n alone
double least_wave_modulus(const DeformedPoint& point, bool isochoric);

}  // namespace pliant
