#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "pliant/capture/rig_checks.h"
#include "pliant/capture/triangulation.h"

namespace pliant {
namespace {

// A tag's corners in a picture that is used for its shot.
struct TagSighting {
  int camera = 0;
  Eigen::Matrix<double, 2, 4> corners;
};

using TagsOfShots = std::map<int, std::vector<TagSighting>>;  // by shot

TagsOfShots tags_of(int code, const std::vector<RigPicture>& pictures, const Bundle& bundle) {
  TagsOfShots result;
  for (const RigPicture& picture : pictures) {
    for (const DetectedTag& tag : picture.findings.other_tags) {
      if (tag.code != code) continue;
      result[picture.shot].push_back(
          {picture.camera, tag.corners_by(bundle.cameras[picture.camera])});
    }
  }
  return result;
}

// Rig axes of the plane in which a board lies in a shot.
std::optional<RigidMotion> board_in(int shot, const Bundle& bundle,
                                    const std::vector<RigPicture>& pictures) {
  for (const CornerView& view : bundle.views) {
    if (pictures[view.picture].shot == shot) return bundle.placements[view.placement].pose;
  }
  return std::nullopt;
}

std::optional<Eigen::Vector3d> on_plane(const SightRay& ray, const RigidMotion& board) {
  const Eigen::Vector3d normal = board.matrix().col(2);
  const double along = normal.dot(ray.direction);
  if (std::abs(along) < 1e-6) return std::nullopt;
  return ray.from + ray.direction * normal.dot(board.translation - ray.from) / along;
}

// A place of a tag's plane; four corners from all pictures of one shot.
std::optional<Eigen::Vector3d> corner_in_space(const std::vector<TagSighting>& seen, int corner,
                                               const Bundle& bundle,
                                               const std::optional<RigidMotion>& board) {
  if (board) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const TagSighting& tag : seen) {
      const auto ray = bundle.cameras[tag.camera].ray(tag.corners.col(corner));
      const auto point = ray ? on_plane(*ray, *board) : std::nullopt;
      if (!point) return std::nullopt;
      sum += *point;
    }
    return sum / static_cast<double>(seen.size());
  }
  std::vector<Sighting> sightings;
  for (const TagSighting& tag : seen) {
    sightings.push_back(
        {&bundle.cameras[tag.camera], tag.corners.col(corner), bundle.noise[tag.camera]});
  }
  const auto point = triangulate(sightings);
  return point ? std::optional(point->point) : std::nullopt;
}

using TagInSpace = std::optional<Eigen::Matrix<double, 3, 4>>;

TagInSpace tag_in_space(const std::vector<TagSighting>& seen, const Bundle& bundle,
                        const std::optional<RigidMotion>& board) {
  Eigen::Matrix<double, 3, 4> corners;
  for (int i = 0; i < 4; ++i) {
    const auto corner = corner_in_space(seen, i, bundle, board);
    if (!corner) return std::nullopt;
    corners.col(i) = *corner;
  }
  return corners;
}

std::vector<double> measured_lengths(const SecondLength& length, const Bundle& bundle,
                                     const std::vector<RigPicture>& pictures) {
  const TagsOfShots first = tags_of(length.first, pictures, bundle);
  const TagsOfShots second = tags_of(length.second, pictures, bundle);
  std::vector<double> lengths;
  for (const auto& [shot, seen] : first) {
    const auto other = second.find(shot);
    if (other == second.end()) continue;
    std::optional<RigidMotion> board;
    if (length.on_board) {
      board = board_in(shot, bundle, pictures);
      if (!board) continue;
    }
    const TagInSpace a = tag_in_space(seen, bundle, board);
    const TagInSpace b = tag_in_space(other->second, bundle, board);
    if (!a || !b) continue;
    if (length.first != length.second) {
      lengths.push_back((a->rowwise().mean() - b->rowwise().mean()).norm());
      continue;
    }
    double sides = 0;
    for (int i = 0; i < 4; ++i) sides += (a->col(i) - a->col((i + 1) % 4)).norm() / 4;
    lengths.push_back(sides);
  }
  return lengths;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double mean_length(const SecondLength& length, const Bundle& bundle,
                   const std::vector<RigPicture>& pictures) {
  return mean_of(measured_lengths(length, bundle, pictures));
}

// By the cameras' numbers; boards follow the cameras where the length lies on one.
double calibration_variance(const SecondLength& length, const Bundle& bundle,
                            const std::vector<RigPicture>& pictures,
                            const BundleCovariance& covariance) {
  const auto numbers = covariance.cameras.rows();
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(numbers);
  for (int i = 0; i < numbers; ++i) {
    const double step = 0.1 * std::sqrt(covariance.cameras(i, i));
    if (!(step > 0)) continue;
    const auto moved = [&](double by) {
      Bundle other = bundle;
      CameraModel& camera = other.cameras[i / kCameraNumbers];
      const int k = i % kCameraNumbers;
      if (k < kIntrinsics) {
        camera.intrinsics(k) += by;
      } else if (k < kIntrinsics + 3) {
        camera.pose.rotation(k - kIntrinsics) += by;
      } else {
        camera.pose.translation(k - kIntrinsics - 3) += by;
      }
      return mean_length(length, other, pictures);
    };
    slope(i) = (moved(step) - moved(-step)) / (2 * step);
  }
  // Moved cameras that no longer see the length tell no error of it.
  if (!slope.allFinite()) return std::numeric_limits<double>::infinity();
  return slope.dot(covariance.cameras * slope);
}

}  // namespace

LengthCheck check_length(const SecondLength& length, const Bundle& bundle,
                         const std::vector<RigPicture>& pictures,
                         const BundleCovariance& covariance) {
  const std::vector<double> lengths = measured_lengths(length, bundle, pictures);
  if (lengths.empty()) {
    throw InputError(
        length.where,
        length.first == length.second
            ? fmt::format("no shot shows the tag {} to two cameras", length.first)
            : fmt::format("no shot shows the tags {} and {} to two cameras", length.first,
                          length.second),
        "pictures of calibration.pictures that show it beside the board; `on_board: true` where it "
        "lies in the board's plane and one camera sees it");
  }
  LengthCheck check{static_cast<int>(lengths.size()), length.length, mean_of(lengths), 0};
  // One measurement tells no scatter; half a part in a thousand is what a tag's edges allow.
  constexpr double kUnknownScatter = 5e-4;
  double variance = std::pow(kUnknownScatter * check.measured, 2);
  if (lengths.size() > 1) {
    variance = 0;
    for (const double value : lengths) variance += std::pow(value - check.measured, 2);
    variance /= static_cast<double>(lengths.size() - 1);
  }
  variance /= static_cast<double>(lengths.size());
  variance += calibration_variance(length, bundle, pictures, covariance);
  check.error = std::sqrt(variance);
  return check;
}

}  // namespace pliant
