#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/cord_look.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// What several cameras see at once.
struct CordViews {
  std::span<const CameraModel> cameras;
  std::span<const SplinePicture> pictures;
};

/// A cord as a straight line in space.
struct CordLine {
  Eigen::Vector3d from;       ///< where it is fastened (m)
  Eigen::Vector3d direction;  ///< away from there, unit
  double length = 0;          ///< of what was looked at (m)
  double error = 0;           ///< standard deviation of its direction, the larger one (rad)
  double miss = 0;            ///< root mean square by which cameras miss it (pixels)
  double seen = 0;            ///< sum over the cameras of the share of it that each sees
};

/// The line that fits best, by least squares over the places at which each camera sees the cord
/// stand out.
/// @param start  within some pixels of it; its ends move across it alone
/// @return nothing where no two cameras see it
std::optional<CordLine> fitted_cord(const CordViews& views, const CordLook& look,
                                    const CordLine& start);

}  // namespace pliant
