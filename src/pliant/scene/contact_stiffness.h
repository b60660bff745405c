#pragma once

#include "pliant/scene/stepping.h"

namespace pliant {

/// How stiff a barrier is for each mass that it keeps off, so that it stops that within a few steps
/// in time (1/s^2).
inline double contact_stiffness_per_mass(const Stepping& time) {
  return 4 / (time.step * time.step);
}

}  // namespace pliant
