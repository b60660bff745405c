#pragma once

#include <Eigen/Geometry>

namespace pliant {

/// A pinhole camera, upright with respect to `up`.
struct Camera {
  Eigen::Vector3d position{0, -1, 0};             ///< m
  Eigen::Vector3d target{0, 0, 0};                ///< the middle of the picture (m)
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< need not be orthogonal to the view
  double field_of_view = 0.5;                     ///< from bottom to top (rad), in (0, pi)
};

/// Right, up and forward, as orthonormal columns.
Eigen::Matrix3d camera_axes(const Camera& camera);

/// Where a point in front of the camera appears: fractions of the picture's width from the left and
/// of its height from the top.
/// @param aspect  width / height of the picture
Eigen::Vector2d project(const Camera& camera, double aspect, const Eigen::Vector3d& point);

/// Where a scene is seen from, gravity pointing down along -z.
enum class ViewDirection {
  front,               ///< along +y
  back,                ///< along -y
  left,                ///< along +x
  right,               ///< along -x
  top,                 ///< along -z, y upwards
  bottom,              ///< along +z, y downwards
  three_quarter,       ///< from the front, right and above
  three_quarter_back,  ///< from the back, left and above
};

/// Width of what a picture shows at the depth of a point (m); not above 0 behind the camera.
/// @param aspect  width / height of the picture
double width_at(const Camera& camera, double aspect, const Eigen::Vector3d& point);

/// What stays free at the edges of a picture, as fractions of its width and height.
struct Margins {
  double left = 0.06;
  double right = 0.06;
  double top = 0.06;
  double bottom = 0.06;
};

/// The camera nearest to `box` that has all of it in the picture, within the margins.
/// @param box     not empty; it may be flat or a point
/// @param aspect  width / height of the picture
Camera fit_camera(const Eigen::AlignedBox3d& box, ViewDirection direction, double aspect,
                  const Margins& margins = {});

}  // namespace pliant
