#pragma once

#include <array>

namespace pliant {

/// Parameters of Dahl friction with a maximum stress that grows with strain ([T] Eq. 5.2):
/// sigma_max(strain) = a + b |strain|.
struct DahlParameters {
  double a = 0;    ///< maximum friction stress at zero strain (N/m for membranes, N for bending)
  double b = 0;    ///< its growth with strain (N/m for membranes, N m for bending)
  double tau = 1;  ///< strain over which friction follows a reversal (unit of the strain), > 0
};

/// Strain and friction stress of one material point.
struct FrictionState {
  double strain = 0;
  double stress = 0;
};

/// A friction stress and its derivatives with respect to everything it depends on.
struct FrictionStress {
  double stress = 0;
  double slope = 0;                    ///< d stress / d strain
  double from_strain = 0;              ///< d stress / d strain at the start of the stretch
  double from_stress = 0;              ///< d stress / d stress at the start of the stretch
  std::array<double, 3> parameters{};  ///< d stress / d (a, b, tau)
};

double max_friction_stress(const DahlParameters& dahl, double strain);

/// Friction stress along one monotone stretch of strain: the exact solution of [T] Eq. 5.2, through
/// zero strain if the stretch crosses it.
///
/// On one side of zero (g = sign of the strain) and for one sign s of the strain rate the solution
/// is s (a + b |strain|) - g b tau + C exp(-s (strain - strain0) / tau). The papers' Eq. 5.3 drops
/// the offset g b tau; it is kept here because it makes the solution exact at no cost.
///
/// A stretch of no length keeps the stress; its slope is then that of the loading side.
/// @param strain  new strain (dimensionless for membranes, 1/m for bending)
/// @param from    strain and friction stress at the start of the stretch
/// @return the friction stress at `strain`; its slope is never below -b
FrictionStress friction_stress(const DahlParameters& dahl, double strain,
                               const FrictionState& from);

/// Dahl friction whose parameters differ by the side of zero strain ([P] 4.1).
struct DahlBySide {
  DahlParameters positive;
  DahlParameters negative;

  const DahlParameters& at(double strain) const { return strain < 0 ? negative : positive; }
};

/// A friction stress with its derivatives by the parameters of each side.
struct FrictionStressBySide {
  FrictionStress friction;  ///< `parameters` are those of positive strain
  std::array<double, 3> negative_parameters{};
};

FrictionStressBySide friction_stress(const DahlBySide& dahl, double strain,
                                     const FrictionState& from);

/// Work against friction along the same stretch: the integral of its stress over strain (J/m^2 for
/// membranes and for bending).
double friction_work(const DahlBySide& dahl, double strain, const FrictionState& from);

}  // namespace pliant
