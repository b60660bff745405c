#pragma once

#include <vector>

#include "pliant/capture/camera_model.h"
#include "pliant/geometry/pose.h"

namespace pliant {

/// A point of a rigid body that a camera sees.
struct BodySighting {
  const CameraModel* camera = nullptr;
  Eigen::Vector3d point;  ///< of the body where it was at rest, rig axes (m)
  Eigen::Vector2d pixel;
};

/// How a body has moved, by least squares over the pixels [Huber1981], in the end without those
/// that miss by much more than most: what is partly hidden is seen elsewhere.
/// @param start  near to it
/// @param noise  of a coordinate (pixels)
Pose sighted_pose(const std::vector<BodySighting>& sightings, const Pose& start, double noise);

}  // namespace pliant
