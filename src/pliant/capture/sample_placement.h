#pragma once

#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/quadrilateral.h"

namespace pliant {

/// Where a flat sample lies before a rig.
struct SamplePlacement {
  Eigen::Isometry3d to_sample;  ///< from rig axes to u, v and off the plane
  Eigen::Vector2d sides;        ///< mean distances of the corners along weft and warp (m)
};

/// The sample lies in the plane through its points; its axes are those of its corners there.
/// @param points   3 x points of the sample, rig axes (m)
/// @param corners  that the camera sees (pixels): of least u and v, largest u, largest both,
///                 largest v
/// @param size     width and height of the sample (m)
/// @return nothing where the camera does not see the plane at its corners
std::optional<SamplePlacement> place_sample(const Eigen::Matrix3Xd& points,
                                            const Quadrilateral& corners, const CameraModel& camera,
                                            const Eigen::Vector2d& size);

/// What to say where a sample is seen larger or smaller than it is said to be, by 1.5 % or more;
/// else nothing.
/// @param seen, stated  its width or height (m)
/// @param which         "wide" or "high"
std::string size_doubt(double seen, double stated, const char* which);

}  // namespace pliant
