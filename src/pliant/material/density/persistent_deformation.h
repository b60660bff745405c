#pragma once

namespace pliant {

/// Dahl friction with constant maximum stress, told by what it does to a linear elastic material
/// instead of by sigma_max and tau ([T] 5.2.3). Strains and `stiffness` in the units of the
/// component.
struct FrictionAppearance {
  double persistent = 0;  ///< strain that remains after saturated unloading without weight
  double saturation = 0;  ///< strain after which friction counts as saturated, > persistent
};

struct ConstantFriction {
  double max_stress = 0;
  double tau = 0;
};

/// Share of the maximum stress at which [T] 5.2.3 calls friction saturated.
inline constexpr double kSaturationShare = 0.95;

/// sigma_max = k eps_per and tau = (eps_sat - eps_per) / ln(2 / (1 - c)) ([T] 5.2.3, with tau =
/// sigma_max / alpha).
/// @param share  c, the share of sigma_max that counts as saturated, in (0, 1)
/// @throws AssertionError unless 0 <= persistent < saturation, stiffness > 0 and share lies in (0,
/// 1)
ConstantFriction friction_from(const FrictionAppearance& appearance, double stiffness,
                               double share = kSaturationShare);

/// The inverse of `friction_from`.
FrictionAppearance appearance_of(const ConstantFriction& friction, double stiffness,
                                 double share = kSaturationShare);

}  // namespace pliant
