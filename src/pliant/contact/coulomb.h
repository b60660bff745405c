#pragma once

#include <Eigen/Core>

namespace pliant {

/// Coefficients of friction between two surfaces.
struct CoulombFriction {
  double sticking = 0;  ///< of surfaces that rest on each other
  double sliding = 0;   ///< at most the same
};

/// How far a contact gives way elastically before it slides (m): what rests stays within it.
inline constexpr double kSlipLength = 2e-6;

/// Energy of a tangential displacement and its derivatives by it.
struct SlipEnergy {
  double energy = 0;        ///< J
  Eigen::Vector3d force;    ///< dE / d displacement, N
  Eigen::Matrix3d hessian;  ///< N/m, positive semidefinite
};

/// Coulomb's friction as an energy over one step: elastic up to the slip length, then of the
/// constant force `bound`. Convex, with a continuous slope.
/// @param slip   displacement from where the contact carries no force, in the tangent plane (m)
/// @param bound  coefficient times normal force (N)
/// @param plane  projection onto the tangent plane
SlipEnergy slip_energy(const Eigen::Vector3d& slip, double bound, const Eigen::Matrix3d& plane);

/// The part of a slip that is elastic: what remains of it where the contact slides.
Eigen::Vector3d elastic_slip(const Eigen::Vector3d& slip);

}  // namespace pliant
