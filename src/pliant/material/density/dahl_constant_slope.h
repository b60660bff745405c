#pragma once

#include "pliant/material/density/dahl.h"

namespace pliant {

/// Dahl friction in its first form with gamma = 1 ([T] Eq. 5.1): the slope alpha of the friction
/// stress at zero stress is constant, so that tau = sigma_max / alpha grows with strain. [T]
/// Fig. 5.3 (right) compares it.
struct ConstantSlopeParameters {
  double a = 0;      ///< maximum friction stress at zero strain, > 0
  double b = 0;      ///< its growth with |strain|
  double alpha = 1;  ///< slope of the friction stress where it is zero, > 0
};

/// Friction stress along one monotone stretch of strain: the exact solution of
/// d sigma / d strain = alpha (1 - s sigma / (a + b |strain|)), through zero strain if the stretch
/// crosses it.
/// @return the stress; `parameters` are the derivatives w.r.t. (a, b, alpha)
FrictionStress friction_stress(const ConstantSlopeParameters& dahl, double strain,
                               const FrictionState& from);

}  // namespace pliant
