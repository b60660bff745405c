#include "pliant/render/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

// Long enough a lens for little perspective distortion.
constexpr double kFieldOfView = 26 * std::numbers::pi / 180;
constexpr double kThinnestBox = 1e-3;  // of the diagonal
constexpr double kSmallestBox = 1e-3;  // m, for a box that is a point

struct Pose {
  Eigen::Vector3d forward;
  Eigen::Vector3d up;
};

Pose pose_of(ViewDirection direction) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  switch (direction) {
    case ViewDirection::front:
      return {Eigen::Vector3d::UnitY(), z};
    case ViewDirection::back:
      return {-Eigen::Vector3d::UnitY(), z};
    case ViewDirection::left:
      return {Eigen::Vector3d::UnitX(), z};
    case ViewDirection::right:
      return {-Eigen::Vector3d::UnitX(), z};
    case ViewDirection::top:
      return {-z, Eigen::Vector3d::UnitY()};
    case ViewDirection::bottom:
      return {z, -Eigen::Vector3d::UnitY()};
    case ViewDirection::three_quarter_back:
      return {Eigen::Vector3d(0.55, -1, -0.48).normalized(), z};
    case ViewDirection::three_quarter:
      break;
  }
  return {Eigen::Vector3d(-0.55, 1, -0.48).normalized(), z};
}

/// Places the camera along one axis of the picture so that the extent of the box fits between the
/// lines of sight with slopes -low_slope and high_slope against the view.
class AxisFit {
 public:
  AxisFit(double low_slope, double high_slope) : low_slope_(low_slope), high_slope_(high_slope) {}

  void add(double across, double along) {
    low_ = std::max(low_, -across - low_slope_ * along);
    high_ = std::max(high_, across - high_slope_ * along);
  }
  /// The foremost position along the view from which everything is between the lines.
  double foremost() const { return -(low_ + high_) / (low_slope_ + high_slope_); }
  /// The position across the view that centres the extent.
  double centre(double along) const {
    return (high_ + high_slope_ * along - low_ - low_slope_ * along) / 2;
  }

 private:
  double low_slope_;
  double high_slope_;
  double low_ = -std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

/// The box, a little thicker where it is flat or a point, so that no camera stands on it.
Eigen::AlignedBox3d with_extent(const Eigen::AlignedBox3d& box) {
  const double diagonal = box.diagonal().norm();
  const double least = diagonal > 0 ? kThinnestBox * diagonal : kSmallestBox;
  const Eigen::Vector3d half = box.sizes().cwiseMax(least) / 2;
  return {box.center() - half, box.center() + half};
}

}  // namespace

Eigen::Matrix3d camera_axes(const Camera& camera) {
  const Eigen::Vector3d forward = (camera.target - camera.position).normalized();
  const Eigen::Vector3d right = forward.cross(camera.up).normalized();
  Eigen::Matrix3d axes;
  axes << right, right.cross(forward), forward;
  return axes;
}

Eigen::Vector2d project(const Camera& camera, double aspect, const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = camera_axes(camera).transpose() * (point - camera.position);
  const double slope = std::tan(camera.field_of_view / 2);
  return {0.5 + p.x() / (2 * slope * aspect * p.z()), 0.5 - p.y() / (2 * slope * p.z())};
}

double width_at(const Camera& camera, double aspect, const Eigen::Vector3d& point) {
  const double depth = camera_axes(camera).col(2).dot(point - camera.position);
  return 2 * std::tan(camera.field_of_view / 2) * aspect * depth;
}

Camera fit_camera(const Eigen::AlignedBox3d& box, ViewDirection direction, double aspect,
                  const Margins& margins) {
  PLIANT_ASSERT(!box.isEmpty(), "a view shows something");
  const Pose pose = pose_of(direction);
  const Eigen::AlignedBox3d shown = with_extent(box);
  Camera camera;
  camera.position.setZero();
  camera.target = pose.forward;
  camera.up = pose.up;
  camera.field_of_view = kFieldOfView;
  const Eigen::Matrix3d axes = camera_axes(camera);

  const double slope = std::tan(kFieldOfView / 2);
  AxisFit x(slope * aspect * (1 - 2 * margins.left), slope * aspect * (1 - 2 * margins.right));
  AxisFit y(slope * (1 - 2 * margins.bottom), slope * (1 - 2 * margins.top));
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner =
        axes.transpose() * shown.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
    x.add(corner.x(), corner.z());
    y.add(corner.y(), corner.z());
  }
  const double along = std::min(x.foremost(), y.foremost());
  camera.position = axes * Eigen::Vector3d(x.centre(along), y.centre(along), along);
  const double distance = pose.forward.dot(shown.center() - camera.position);
  camera.target = camera.position + distance * pose.forward;
  return camera;
}

}  // namespace pliant
