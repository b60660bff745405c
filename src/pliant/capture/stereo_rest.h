#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/run_context.h"
#include "pliant/capture/camera_model.h"
#include "pliant/capture/quadrilateral.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// Where a camera sees a point.
struct SeenPlace {
  Eigen::Vector2d pixel;
  double noise = 0;  ///< of a coordinate (pixels)
  int side = 0;      ///< of the square that was seen there (pixels); 0 at rest: all of it
};

/// A point by several cameras, of which one at a time is left out that disagrees.
struct AgreedPoint {
  Eigen::Vector3d position;    ///< rig axes (m)
  Eigen::Matrix3d covariance;  ///< by the noise of the places alone (m^2)
  double miss = 0;             ///< root mean square by which they disagree (pixels a coordinate)
  std::vector<bool> used;      ///< by camera
};

/// A point of the sample, by the first pictures of several cameras.
struct RestPoint {
  AgreedPoint agreed;
  std::vector<std::optional<SeenPlace>> seen;  ///< by camera; in two at least
};

/// What the first pictures show of the sample.
struct StereoRest {
  std::vector<RestPoint> points;
  int places = 0;           ///< that were looked for
  int without_texture = 0;  ///< of them
  std::vector<int> shared;  ///< by camera: points that it shares with the first; the first: all
  double median_miss = 0;   ///< of the points (pixels)
};

/// How patches are laid over a picture.
struct PatchGrid {
  int radius = 10;  ///< 2 radius + 1 pixels a side
  int step = 10;    ///< pixels
};

/// Patches of the first camera's picture that the others see too: found along their lines of sight,
/// and where those around them were found.
/// @param cameras   two at least
/// @param pictures  of each camera, the same moment
/// @param corners   of the sample in the first picture (pixels), one after the other
StereoRest match_rest(const std::vector<CameraModel>& cameras,
                      const std::vector<GreyPicture>& pictures, const Quadrilateral& corners,
                      const PatchGrid& grid, const RunContext& context);

/// A point by cameras that agree.
/// @param most  by which cameras may disagree (pixels)
/// @return nothing where no two cameras agree
std::optional<AgreedPoint> agreed_point(const std::vector<CameraModel>& cameras,
                                        std::vector<std::optional<SeenPlace>> seen, double most);

/// By how much cameras that see the same may disagree: several times what they mostly do.
double most_miss(double median_miss);

}  // namespace pliant
