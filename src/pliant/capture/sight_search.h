#pragma once

#include <vector>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/reference_patch.h"

namespace pliant {

/// Where a camera may see what another sees at a pixel: along that line of sight, on small planes
/// that face the cameras or are tilted to any of four sides.
/// @param from   that sees it at `pixel`
/// @param to     that may see it
/// @param apart  from place to place in the picture of `to` (pixels)
/// @return motions from the one picture to the other, none outside of it
std::vector<PatchMotion> sight_candidates(const CameraModel& from, const CameraModel& to,
                                          const Eigen::Vector2d& pixel, double apart);

}  // namespace pliant
