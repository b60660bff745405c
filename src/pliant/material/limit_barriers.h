#pragma once

#include <array>

#include "pliant/material/density/density.h"

namespace pliant {

/// Barriers that a search for an equilibrium at limits of energy follows, one from where the one
/// before led. They are finite beyond a limit, so that a search may begin there and may pass by
/// there, and each is lower and steeper than the one before. The last holds the multipliers of two
/// hundred within the limit; what it leaves beyond is held by no multiplier worth the name.
///
/// After them `LimitBarrier{}` is near: it differs beyond limits alone.
inline constexpr std::array<LimitBarrier, 6> kLimitBarriers{
    {{1e-2, 1e-2}, {1e-3, 1e-3}, {1e-4, 1e-4}, {1e-5, 1e-5}, {1e-6, 1e-6}, {1e-6, 5e-9}}};

}  // namespace pliant
