#pragma once

#include "pliant/material/addend/addend_kind.h"

namespace pliant {

/// Elasticity that strain takes away for good (`SofteningDensity`).
const AddendKind& softening_addend();

/// Elasticity whose rest follows the largest strain (`SetDensity`).
const AddendKind& set_addend();

/// What relaxes with time (`MaxwellDensity`).
const AddendKind& maxwell_addend();

/// Friction that grows with the logarithm of the rate (`RateFriction`).
const AddendKind& rate_friction_addend();

}  // namespace pliant
