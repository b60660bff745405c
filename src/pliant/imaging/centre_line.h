#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/imaging/strip_mask.h"

namespace pliant {

/// The line in the middle of a strip, in pixels.
struct CentreLine {
  std::vector<Eigen::Vector2d> points;  ///< at equal distances along it, the clamp first
  double length = 0;                    ///< of the smooth line (pixels)
  double clamp_angle = 0;               ///< by which it dips at the clamp (rad)
  double scatter = 0;  ///< root mean square of the measured middles about it (pixels)
};

/// Follows a strip from the left border to its free end, however it turns: pixels are put in order
/// by their way through the strip, the middle is found across it, and a smooth line drawn through.
/// @param count  of points, at least 5
/// @param where  of the picture, for messages
/// @throws InputError where its middle cannot be followed
CentreLine centre_line(const StripMask& strip, int count, const Location& where);

}  // namespace pliant
