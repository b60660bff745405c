#include <cmath>
#include <filesystem>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/capture/rig_checks.h"

namespace pliant {
namespace {

// A user points at a line with a pixel's error.
constexpr double kPointingError = 1;

RigGravity gravity_of_board(const LevelBoard& level, const Bundle& bundle,
                            const std::vector<RigPicture>& pictures,
                            const BundleCovariance& covariance) {
  std::error_code error;
  for (const CornerView& view : bundle.views) {
    const RigPicture& picture = pictures[view.picture];
    if (!std::filesystem::equivalent(picture.file, level.picture, error)) continue;
    const RigidMotion& pose = bundle.placements[view.placement].pose;
    const auto turn = covariance.placements[view.placement].topLeftCorner<3, 3>();
    return {-pose.matrix().col(2), std::sqrt(turn.trace() / 3)};
  }
  for (const RigPicture& picture : pictures) {
    if (!std::filesystem::equivalent(picture.file, level.picture, error)) continue;
    throw InputError(level.where, fmt::format("{} {}", picture.file, picture.left_out),
                     "a picture in which the board was found");
  }
  throw InputError(level.where, "is none of the pictures of `calibration.pictures`",
                   "one of them, in which the board lies on a levelled table");
}

// The plane through a camera's centre and the line that it sees.
Eigen::Vector3d normal_of_plane(const CameraModel& camera, const PlumbLine& line,
                                const Eigen::Vector2d& upper, const Eigen::Vector2d& lower) {
  const auto above = camera.ray(upper), below = camera.ray(lower);
  if (!above || !below) {
    throw InputError(line.where, "has a pixel that sees nothing", "pixels of the picture");
  }
  return above->direction.cross(below->direction).normalized();
}

RigGravity gravity_of_line(const PlumbLine& line, const Bundle& bundle) {
  const PlumbLine::Seen &a = line.seen[0], &b = line.seen[1];
  constexpr double kShortest = 10;  // pixels; less tells no direction
  for (const PlumbLine::Seen& seen : line.seen) {
    if ((seen.upper - seen.lower).norm() >= kShortest) continue;
    throw InputError(line.where, "has pixels that lie too near each other",
                     "the two ends of what is seen of the line");
  }
  const CameraModel &first = bundle.cameras[a.camera], &second = bundle.cameras[b.camera];
  const Eigen::Vector3d m = normal_of_plane(first, line, a.upper, a.lower);
  const Eigen::Vector3d n = normal_of_plane(second, line, b.upper, b.lower);
  const Eigen::Vector3d along = m.cross(n);
  constexpr double kLeastAngle = 0.05;
  if (along.norm() < kLeastAngle) {
    throw InputError(line.where, "lies in a plane with both cameras, and its direction is not seen",
                     "cameras beside each other that see the line, or a level board");
  }
  Eigen::Vector3d direction = along.normalized();
  const auto below = first.ray(a.lower), above = first.ray(a.upper);
  if (direction.dot(below->direction - above->direction) < 0) direction = -direction;
  const auto error_of = [](const PlumbLine::Seen& seen) {
    const double pixels = (seen.upper - seen.lower).norm();
    return std::sqrt(2.0) * kPointingError / pixels;
  };
  const double error = std::hypot(error_of(a), error_of(b)) / along.norm();
  return {direction, error};
}

}  // namespace

std::optional<RigGravity> gravity_of(const GravitySource& source, const Bundle& bundle,
                                     const std::vector<RigPicture>& pictures,
                                     const BundleCovariance& covariance) {
  if (const auto* level = std::get_if<LevelBoard>(&source)) {
    return gravity_of_board(*level, bundle, pictures, covariance);
  }
  if (const auto* line = std::get_if<PlumbLine>(&source)) return gravity_of_line(*line, bundle);
  return std::nullopt;
}

}  // namespace pliant
