#include "pliant/capture/sight_search.h"

#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

namespace pliant {
namespace {

constexpr double kBeside = 4;  // pixels, of the places that tell how a patch is turned
constexpr double kTilt = 0.5;  // rad

bool shows(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < camera.columns && pixel.y() < camera.rows;
}

/// A line of sight and two beside it.
struct Sights {
  SightRay middle;
  std::array<SightRay, 2> beside;  // to the right and below
};

std::optional<Sights> sights_of(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  const auto middle = camera.ray(pixel);
  const auto right = camera.ray(pixel + kBeside * Eigen::Vector2d::UnitX());
  const auto below = camera.ray(pixel + kBeside * Eigen::Vector2d::UnitY());
  if (!middle || !right || !below) return std::nullopt;
  return Sights{*middle, {*right, *below}};
}

/// How a small plane at a point of the line of sight moves from picture to picture.
std::optional<PatchMotion> motion_of(const Sights& sights, const Eigen::Vector3d& point,
                                     const Eigen::Vector3d& normal, const CameraModel& to,
                                     const Eigen::Vector2d& pixel) {
  const auto seen = to.project(point);
  if (!seen || !shows(to, *seen)) return std::nullopt;
  PatchMotion motion{.shift = *seen - pixel};
  for (Eigen::Index k = 0; k < 2; ++k) {
    const SightRay& ray = sights.beside[static_cast<std::size_t>(k)];
    const double way = normal.dot(point - ray.from) / normal.dot(ray.direction);
    if (!(way > 0)) return std::nullopt;
    const auto there = to.project(ray.from + way * ray.direction);
    if (!there) return std::nullopt;
    motion.slope.col(k) = (*there - *seen) / kBeside - Eigen::Vector2d::Unit(k);
  }
  return motion;
}

/// Normals of the planes that are tried at a point.
std::vector<Eigen::Vector3d> normals_at(const Eigen::Vector3d& point, const CameraModel& from,
                                        const CameraModel& to) {
  const Eigen::Vector3d back = from.centre() - point, other = to.centre() - point;
  const Eigen::Vector3d facing = (back.normalized() + other.normalized()).normalized();
  const Eigen::Vector3d across = facing.unitOrthogonal(), along = facing.cross(across);
  std::vector<Eigen::Vector3d> normals{facing};
  for (const double tilt : {-kTilt, kTilt}) {
    for (const Eigen::Vector3d& side : {across, along}) {
      const Eigen::Vector3d normal = std::cos(tilt) * facing + std::sin(tilt) * side;
      // Both cameras look at the same face.
      if (normal.dot(back) > 0 && normal.dot(other) > 0) normals.push_back(normal);
    }
  }
  return normals;
}

}  // namespace

std::vector<PatchMotion> sight_candidates(const CameraModel& from, const CameraModel& to,
                                          const Eigen::Vector2d& pixel, double apart) {
  // Distances from a quarter of the cameras' own to far away, evenly by their inverse.
  constexpr int kSteps = 4000;
  constexpr double kNearest = 0.25;
  std::vector<PatchMotion> candidates;
  const auto sights = sights_of(from, pixel);
  if (!sights) return candidates;
  const double baseline = (to.centre() - from.centre()).norm();
  std::optional<Eigen::Vector2d> last;
  for (int i = 1; i <= kSteps; ++i) {
    const double distance = kNearest * baseline * kSteps / i;
    const Eigen::Vector3d point = sights->middle.from + distance * sights->middle.direction;
    const auto seen = to.project(point);
    if (!seen || !shows(to, *seen) || (last && (*seen - *last).norm() < apart)) continue;
    last = seen;
    for (const Eigen::Vector3d& normal : normals_at(point, from, to)) {
      if (const auto motion = motion_of(*sights, point, normal, to, pixel)) {
        candidates.push_back(*motion);
      }
    }
  }
  return candidates;
}

}  // namespace pliant
