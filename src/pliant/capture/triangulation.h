#pragma once

#include <optional>
#include <vector>

#include "pliant/capture/camera_model.h"

namespace pliant {

/// A place that a camera sees.
struct Sighting {
  const CameraModel* camera = nullptr;
  Eigen::Vector2d pixel;
  double noise = 1;  ///< of a coordinate (pixels)
};

/// A point by what several cameras see of it.
struct TriangulatedPoint {
  Eigen::Vector3d point;       ///< rig axes (m)
  Eigen::Matrix3d covariance;  ///< from the noise of pixels alone (m^2)
  double chi_square = 0;       ///< sum of squared errors over their variance
};

/// Least squares over the pixels, from where the lines of sight come nearest.
/// @return nothing where fewer than two cameras see it, or lines of sight are parallel
std::optional<TriangulatedPoint> triangulate(const std::vector<Sighting>& sightings);

}  // namespace pliant
