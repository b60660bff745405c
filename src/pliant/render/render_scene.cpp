#include "pliant/render/render_scene.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace pliant {

KeyLight light_for_view(const Eigen::Vector3d& forward) {
  constexpr double kTurn = -42 * std::numbers::pi / 180;
  constexpr double kElevation = 52 * std::numbers::pi / 180;
  Eigen::Vector3d backward(-forward.x(), -forward.y(), 0);
  // Straight down, with +y upwards in the picture: from the upper left.
  if (backward.norm() < 1e-6 * forward.norm()) backward = -Eigen::Vector3d::UnitX();
  const Eigen::Vector3d side =
      Eigen::AngleAxisd(kTurn, Eigen::Vector3d::UnitZ()) * backward.normalized();
  KeyLight light;
  const bool looks_up = forward.z() > std::sin(kElevation) * forward.norm();
  const double height = std::sin(looks_up ? -kElevation : kElevation);
  light.direction = std::cos(kElevation) * side + height * Eigen::Vector3d::UnitZ();
  return light;
}

}  // namespace pliant
