#include "pliant/report/sheet_camera.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace pliant::report {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kElevation = 38 * kDegree;
/// From the direction of the sheet that is drawn to the right.
constexpr double kAzimuth = -62 * kDegree;

/// The direction of the rest plane that is drawn to the right, level with the ground.
Eigen::Vector3d level_direction(const Session& session, const Eigen::Vector3d& vertical) {
  const bool warp = session.table == RestAxis::v;
  const Eigen::Vector3d along = Eigen::Vector3d::Unit(warp ? 1 : 0);
  const Eigen::Vector3d level = along - along.dot(vertical) * vertical;
  return level.norm() > 0.1 ? level.normalized() : vertical.unitOrthogonal();
}

}  // namespace

SheetCamera sheet_camera(const Session& session) {
  SheetCamera camera;
  const double gravity = session.gravity.norm();
  camera.vertical = gravity > 0 ? Eigen::Vector3d(-session.gravity / gravity)
                                : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d level = level_direction(session, camera.vertical);
  const Eigen::Vector3d behind = camera.vertical.cross(level);
  camera.towards =
      std::cos(kElevation) * (std::cos(kAzimuth) * level + std::sin(kAzimuth) * behind) +
      std::sin(kElevation) * camera.vertical;
  camera.right = camera.vertical.cross(camera.towards).normalized();
  camera.up = camera.towards.cross(camera.right);
  return camera;
}

}  // namespace pliant::report
