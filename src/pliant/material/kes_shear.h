#pragma once

#include <numbers>

#include "pliant/material/loop_reading.h"
#include "pliant/material/material.h"

namespace pliant {

/// What the shear test of the Kawabata system (KES-FB1) prints: numbers of the loop of shear force
/// per width over the angle between -8 and +8 degrees, once it has closed.
struct KesShear {
  double rigidity = 0;    ///< G: mean slope of both ways from 0.5 to 2.5 degrees (N/m per rad)
  double hysteresis = 0;  ///< 2HG: width of the loop at 0.5 degrees (N/m)
  double hysteresis_at_five = 0;  ///< 2HG5: the same at 5 degrees (N/m)
};

inline constexpr double kKesDegree = std::numbers::pi / 180;
inline constexpr double kKesLargestAngle = 8 * kKesDegree;  ///< where the loop turns
inline constexpr double kKesSlopeAngle[] = {0.5 * kKesDegree, 2.5 * kKesDegree};
inline constexpr double kKesHysteresisAngle[] = {0.5 * kKesDegree, 5 * kKesDegree};

/// Reads a loop of shear force per width over the angle.
KesShear kes_shear(const LoopWays& loop);

/// The numbers that the test would give for a component of shear.
/// @param component  its stiffness is given
KesShear kes_shear(const MaterialComponent& component);

}  // namespace pliant
