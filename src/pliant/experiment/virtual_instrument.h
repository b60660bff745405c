#pragma once

#include <cmath>

#include "pliant/base/random.h"

namespace pliant {

/// Noise and resolution of a virtual instrument (SI); zero: ideal.
struct Instrument {
  double force_noise = 0;   ///< standard deviation; N, or N/m in shear-cycles; of moments per width
                            ///< (N) in pure-bending
  double length_noise = 0;  ///< of each coordinate in cantilever and rolled-strip, of
                            ///< overhangs in bending-length
  double force_resolution = 0;
  double length_resolution = 0;
};

/// A value as an instrument shows it.
inline double measured(double value, double noise, double resolution, RandomStream& random) {
  if (noise > 0) value += noise * random.normal();
  return resolution > 0 ? resolution * std::round(value / resolution) : value;
}

}  // namespace pliant
