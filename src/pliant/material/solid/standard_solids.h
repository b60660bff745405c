#pragma once

#include <Eigen/Core>

#include "pliant/material/material.h"

namespace pliant {

// Standard laws of solids as compositions of addends; numbers in Pa.

/// lambda / 2 tr(E)^2 + mu tr(E^2) ([T] Eq. 4.3).
Material stvk_solid(double lambda, double mu);

/// Half of E . D E for the six Green strains of a body whose axes are x, y and z.
/// @param normal  D of E_xx, E_yy and E_zz, symmetric
/// @param shear   D of 2 E_yz, 2 E_xz and 2 E_xy
Material orthotropic_stvk_solid(const Eigen::Matrix3d& normal, const Eigen::Vector3d& shear);

/// C10 (I1 J^(-2/3) - 3) + kappa / 2 (J - 1)^2: shear modulus 2 C10, bulk modulus kappa.
Material neo_hookean_solid(double c10, double kappa);

}  // namespace pliant
