#pragma once

#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include "pliant/base/random.h"
#include "pliant/capture/camera_model.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// A surface before cameras, seen from both sides.
struct DrawnSurface {
  Eigen::Matrix3Xd positions;  ///< rig axes (m), one column a vertex
  Eigen::Matrix3Xi triangles;
  Eigen::Matrix2Xd places;  ///< of the vertices on the surface (m)
  /// Share of the light that a place throws back, 0 to 1.
  std::function<double(const Eigen::Vector2d& place)> brightness;
  double gloss = 0;  ///< share of the light that is mirrored [Blinn1977], which each camera sees
                     ///< elsewhere
};

/// A rectangle at a height; its places are its first two coordinates.
DrawnSurface flat_rectangle(const Eigen::AlignedBox2d& box, double height,
                            std::function<double(const Eigen::Vector2d& place)> brightness);

/// Light, lens and chip of a camera that draws.
struct ViewOptions {
  Eigen::Vector3d light{0.3, -0.4, -1};  ///< towards it, rig axes; any length
  double ambient = 0.7;                  ///< part of the light that comes from all around, 0 to 1
  double background = 0.25;              ///< brightness of what is behind all surfaces
  double blur = 0.7;                     ///< standard deviation of the lens' spot (pixels)
  int samples = 3;                       ///< along each side of a pixel
};

/// What a camera would see, by rays through its lens: brightness, 0 to 1, without noise.
///
/// A triangle is a plane piece; one with a corner that the lens does not show at all, behind the
/// camera or far aside, is left out. Of two surfaces the nearer one hides the other. The same bits
/// on any number of threads.
GreyPicture draw_view(const CameraModel& camera, const std::vector<DrawnSurface>& surfaces,
                      const ViewOptions& options = {});

/// Noise and steps of a chip.
struct ChipNoise {
  double read = 0.01;  ///< standard deviation in the dark (1: white)
  double shot = 0;     ///< of white; it grows with the root of brightness
  int bits = 8;        ///< of a grey level
};

void add_chip_noise(GreyPicture& picture, const ChipNoise& noise, RandomStream& random);

}  // namespace pliant
