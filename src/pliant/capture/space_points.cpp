#include "pliant/capture/space_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/SVD>
#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/camera_picture.h"

namespace pliant {
namespace {

/// The plane through points: a point of it and its normal.
struct Plane {
  Eigen::Vector3d middle, normal;
};

Plane plane_through(const std::vector<RestPoint>& points) {
  Eigen::Matrix3Xd places(3, std::ssize(points));
  for (std::size_t i = 0; i < points.size(); ++i) {
    places.col(static_cast<Eigen::Index>(i)) = points[i].position;
  }
  const Eigen::Vector3d middle = places.rowwise().mean();
  const Eigen::Matrix3Xd centred = places.colwise() - middle;
  const Eigen::JacobiSVD<Eigen::Matrix3d> spread(centred * centred.transpose(),
                                                 Eigen::ComputeFullU);
  return {middle, spread.matrixU().col(2)};
}

}  // namespace

SpacePoints::SpacePoints(const DicFile& dic, ReadPicture read_picture, const RunContext& context)
    : dic_(dic), read_picture_(std::move(read_picture)), context_(context) {
  std::vector<GreyPicture> first = pictures(0);
  const PatchGrid grid{views().patch / 2, views().step};
  StereoRest rest = match_rest(views().cameras, first, views().corners, grid, context_);
  require_sight(rest);
  clips_.resize(dic_.clips.size());
  if (std::ranges::any_of(dic_.clips, [](const DicClip& clip) { return !clip.labels.empty(); })) {
    labels_ = std::make_unique<SpaceLabels>(dic_, first, context_.threads);
    for (std::size_t i = 0; i < clips_.size(); ++i) {
      if (!dic_.clips[i].labels.empty()) clips_[i] = Pose();
    }
  }
  rest_miss_ = rest.median_miss;
  place_sample(rest);
  begin_views(rest, std::move(first));
  lost_at_rest_ = rest.places - static_cast<int>(rest.points.size());
  rest_ = std::move(rest.points);
  for (const RestPoint& point : rest_) {
    now_.push_back(AgreedPoint{point.position, Eigen::Matrix3d::Zero(), point.miss, {}});
  }
}

int SpacePoints::count() const { return static_cast<int>(views().files.front().size()); }

std::string SpacePoints::file(int frame) const {
  return views().files.front()[static_cast<std::size_t>(frame)].string();
}

double SpacePoints::patch() const {
  const double pixel = (views().corners.col(1) - views().corners.col(0)).norm() +
                       (views().corners.col(3) - views().corners.col(0)).norm();
  return views().patch * corner_sides_.sum() / pixel;
}

std::vector<GreyPicture> SpacePoints::pictures(int frame) const {
  std::vector<GreyPicture> pictures;
  for (std::size_t c = 0; c < views().cameras.size(); ++c) {
    const auto& file = views().files[c][static_cast<std::size_t>(frame)];
    pictures.push_back(read_camera_picture(read_picture_, file, views().cameras[c]));
  }
  return pictures;
}

void SpacePoints::require_sight(const StereoRest& rest) const {
  constexpr double kFewest = 0.5;  // of the places
  constexpr double kMostMiss = 1;  // pixels
  const auto places = static_cast<double>(rest.places);
  if (rest.places == 0 || rest.without_texture > kFewest * places) {
    throw InputError({file(0)},
                     fmt::format("{} of {} patches within `corners` have no texture to be found "
                                 "again",
                                 rest.without_texture, rest.places),
                     "a sample with a fine irregular pattern all over, in focus");
  }
  for (std::size_t c = 1; c < rest.shared.size(); ++c) {
    if (rest.shared[c] > kFewest * places) continue;
    throw InputError(
        {views().files[c].front().string()},
        fmt::format("{} of {} patches of the sample that the camera {} sees are found in this "
                    "picture of {}",
                    rest.shared[c], rest.places, views().names.front(), views().names[c]),
        "pictures of one moment, of cameras that have not been exchanged, moved or refocused since "
        "they were calibrated");
  }
  if (rest.median_miss > kMostMiss || static_cast<double>(rest.points.size()) < kFewest * places) {
    throw InputError(
        {dic_.file, 0, "pictures.calibration"},
        fmt::format("does not fit the first pictures: what two cameras see of a point misses by "
                    "{:.2g} pixels",
                    rest.median_miss),
        "a calibration of these cameras where they stand now, none exchanged, moved or refocused");
  }
}

// The axes of the sample are those of its corners in the plane of the points.
void SpacePoints::place_sample(const StereoRest& rest) {
  const CameraModel& camera = views().cameras.front();
  const Plane plane = plane_through(rest.points);
  Eigen::Matrix<double, 3, 4> corners;
  for (int k = 0; k < 4; ++k) {
    const auto ray = camera.ray(views().corners.col(k));
    const double way =
        ray ? plane.normal.dot(plane.middle - ray->from) / plane.normal.dot(ray->direction) : -1;
    if (!(way > 0)) {
      throw InputError({dic_.file, 0, "pictures.corners"}, "are not all seen in the sample's plane",
                       "the sample's corners, in pixels of the first camera's first picture");
    }
    corners.col(k) = ray->from + way * ray->direction;
  }
  corner_sides_ << ((corners.col(1) - corners.col(0)).norm() +
                    (corners.col(2) - corners.col(3)).norm()) /
                       2,
      ((corners.col(3) - corners.col(0)).norm() + (corners.col(2) - corners.col(1)).norm()) / 2;
  const double width = dic_.sample.width, height = dic_.sample.height;
  Eigen::Matrix<double, 3, 4> own;
  own << 0, width, width, 0, 0, 0, height, height, 0, 0, 0, 0;
  const Eigen::Matrix4d fitted = Eigen::umeyama(corners, own, false);
  to_sample_ = Eigen::Isometry3d(fitted);
}

void SpacePoints::begin_views(const StereoRest& rest, std::vector<GreyPicture> pictures) {
  for (std::size_t c = 0; c < pictures.size(); ++c) {
    View view;
    view.tracker = std::make_unique<PatchTracker>(std::move(pictures[c]), views().patch / 2,
                                                  views().step, context_);
    for (std::size_t i = 0; i < rest.points.size(); ++i) {
      const auto& seen = rest.points[i].seen[c];
      if (seen && view.tracker->add(seen->pixel)) view.points.push_back(static_cast<int>(i));
    }
    follow_.push_back(std::move(view));
  }
}

std::string SpacePoints::follow(int frame) {
  context_.stop.throw_if_requested();
  const std::vector<GreyPicture> now = pictures(frame);
  if (labels_) {
    LabelledMotions motions = labels_->motions(now);
    if (!motions.missing.empty()) return motions.missing;
    clips_ = std::move(motions.clips);
  }
  using Seen = std::vector<std::optional<SeenPlace>>;
  std::vector<Seen> seen(rest_.size(), Seen(follow_.size()));
  for (std::size_t c = 0; c < follow_.size(); ++c) {
    const View& view = follow_[c];
    view.tracker->follow(now[c]);
    for (std::size_t i = 0; i < view.points.size(); ++i) {
      const TrackedPatch& patch = view.tracker->patches()[i];
      if (!patch.is_seen) continue;
      const auto point = static_cast<std::size_t>(view.points[i]);
      const double noise = std::sqrt(patch.covariance.trace() / 2);
      seen[point][c] = SeenPlace{patch.now(), std::hypot(noise, rest_[point].seen[c]->noise)};
    }
  }
  const double most = most_miss(rest_miss_);
  with_threads(context_.threads, [&] {
    parallel_for(static_cast<int>(rest_.size()), [&](int i) {
      const auto point = static_cast<std::size_t>(i);
      now_[point] = agreed_point(views().cameras, seen[point], most);
    });
  });
  return "";
}

Pose SpacePoints::in_sample(const Pose& motion) const {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = motion.rotation.toRotationMatrix();
  moved.translation() = motion.translation;
  const Eigen::Isometry3d own = to_sample_ * moved * to_sample_.inverse();
  return {Eigen::Quaterniond(own.linear()).normalized(), own.translation()};
}

PointFrame SpacePoints::read(int frame) {
  PointFrame points;
  if (frame != frame_) {
    frame_ = frame;
    points.left_out = follow(frame);
    if (!points.left_out.empty()) return points;
  }
  for (const auto& clip : clips_) {
    points.clips.push_back(clip ? std::optional(in_sample(*clip)) : std::nullopt);
  }
  std::vector<Eigen::Vector3d> rest, moved;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (!now_[i]) continue;
    rest.push_back(to_sample_ * rest_[i].position);
    moved.push_back(to_sample_ * now_[i]->position);
  }
  points.rest.resize(3, std::ssize(rest));
  points.moved.resize(3, std::ssize(rest));
  for (std::size_t i = 0; i < rest.size(); ++i) {
    points.rest.col(static_cast<Eigen::Index>(i)) = rest[i];
    points.moved.col(static_cast<Eigen::Index>(i)) = moved[i];
  }
  points.lost = static_cast<int>(rest_.size() - rest.size()) + lost_at_rest_;
  return points;
}

std::vector<std::string> SpacePoints::notes() const {
  const auto length = [](double metres) { return format_quantity(metres, Dimension::length, 4); };
  return {fmt::format("{} points are seen by two cameras or more; their lines of sight miss each "
                      "other by {:.2g} pixels in the median",
                      rest_.size(), rest_miss_),
          fmt::format("by the cameras the sample's corners are {} x {} apart, where it is said to "
                      "be {} x {}",
                      length(corner_sides_.x()), length(corner_sides_.y()),
                      length(dic_.sample.width), length(dic_.sample.height))};
}

std::optional<Eigen::Vector3d> SpacePoints::gravity() const {
  if (!views().down) return std::nullopt;
  return kStandardGravity * (to_sample_.linear() * *views().down).normalized();
}

}  // namespace pliant
