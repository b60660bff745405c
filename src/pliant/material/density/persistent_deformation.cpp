#include "pliant/material/density/persistent_deformation.h"

#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

// Number of tau that friction needs from -sigma_max to share * sigma_max.
double strain_constants_to_saturate(double share) {
  PLIANT_ASSERT(share > 0 && share < 1, "the share that counts as saturated lies between 0 and 1");
  return std::log(2 / (1 - share));
}

}  // namespace

ConstantFriction friction_from(const FrictionAppearance& appearance, double stiffness,
                               double share) {
  PLIANT_ASSERT(stiffness > 0, "the elastic stiffness is positive");
  PLIANT_ASSERT(appearance.persistent >= 0 && appearance.saturation > appearance.persistent,
                "friction saturates beyond the persistent strain");
  return {stiffness * appearance.persistent,
          (appearance.saturation - appearance.persistent) / strain_constants_to_saturate(share)};
}

FrictionAppearance appearance_of(const ConstantFriction& friction, double stiffness, double share) {
  PLIANT_ASSERT(stiffness > 0, "the elastic stiffness is positive");
  const double persistent = friction.max_stress / stiffness;
  return {persistent, persistent + friction.tau * strain_constants_to_saturate(share)};
}

}  // namespace pliant
