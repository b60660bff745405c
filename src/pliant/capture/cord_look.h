#pragma once

#include <optional>

#include <Eigen/Core>

#include "pliant/capture/spline_picture.h"

namespace pliant {

/// How a cord looks across: a line that is brighter, or darker, than what is on both its sides.
struct CordLook {
  double sign = 1;      ///< 1 where it is brighter, -1 where it is darker
  double side = 3;      ///< from its middle to what is beside it (pixels)
  double contrast = 0;  ///< of brightness, against the side that is more like it

  /// By how much a place stands out from both its sides, in contrasts of the cord, -1 to 1.
  /// @param across  unit
  double ridge(const SplinePicture& picture, const Eigen::Vector2d& place,
               const Eigen::Vector2d& across) const;
};

/// A cord that a user pointed at, and the pixels of its ends that fit best.
struct PointedCord {
  CordLook look;
  Eigen::Vector2d from, to;
};

/// What a cord looks like between two pixels, each of which may miss it by some.
/// @return nothing where no line is seen there
std::optional<PointedCord> look_of_cord(const SplinePicture& picture, const Eigen::Vector2d& from,
                                        const Eigen::Vector2d& to);

}  // namespace pliant
