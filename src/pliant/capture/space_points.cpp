#include "pliant/capture/space_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/camera_picture.h"
#include "pliant/capture/median.h"
#include "pliant/capture/picture_doubt.h"
#include "pliant/capture/repeating_texture.h"

namespace pliant {
namespace {

/// Side of the squares that cameras saw of a point (pixels): root mean square, since what bends
/// within them counts by its square.
double mean_side(const std::vector<std::optional<SeenPlace>>& seen, const std::vector<bool>& used) {
  double squares = 0, count = 0;
  for (std::size_t c = 0; c < seen.size(); ++c) {
    if (!used[c]) continue;
    squares += seen[c]->side * seen[c]->side;
    ++count;
  }
  return std::sqrt(squares / count);
}

}  // namespace

SpacePoints::SpacePoints(const DicFile& dic, ReadPicture read_picture, const RunContext& context)
    : dic_(dic), read_picture_(std::move(read_picture)), context_(context) {
  std::vector<GreyPicture> first = pictures(0);
  clips_.resize(dic_.clips.size());
  const std::vector<TagsByCode> tags = tags_in(first);
  if (!dic_.label_codes().empty()) {
    labels_ = std::make_unique<SpaceLabels>(dic_, first, tags);
    for (std::size_t i = 0; i < clips_.size(); ++i) {
      if (!dic_.clips[i].labels.empty()) clips_[i] = Pose();
    }
  }
  begin_fixed(first, tags);
  const PatchGrid grid{views().patch / 2, views().step};
  StereoRest rest = match_rest(views().cameras, first, views().corners, grid, context_);
  require_sight(rest);
  rest_miss_ = rest.median_miss;
  lost_at_rest_ = rest.places - static_cast<int>(rest.points.size());
  rest_ = std::move(rest.points);
  find_sample();
  begin_cords(first);
  begin_views(std::move(first));
  for (const RestPoint& point : rest_) now_.emplace_back(point.agreed);
  sides_.setConstant(std::ssize(rest_), views().patch);
  tell_errors();
  const PatchTracker& tracker = *follow_.front().tracker;
  warnings_ = repeat_warnings(tracker.first(), tracker.found().places, context_.threads);
}

Eigen::Vector2d SpacePoints::size() const { return {dic_.sample.width, dic_.sample.height}; }

Eigen::Matrix3Xd SpacePoints::rest_positions() const {
  Eigen::Matrix3Xd positions(3, std::ssize(rest_));
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    positions.col(static_cast<Eigen::Index>(i)) = rest_[i].agreed.position;
  }
  return positions;
}

void SpacePoints::find_sample() {
  const auto placement =
      place_sample(rest_positions(), views().corners, views().cameras.front(), size());
  if (!placement) {
    throw InputError({dic_.file, 0, "views.corners"}, "are not all seen in the sample's plane",
                     "the sample's corners, in pixels of the first camera's first picture");
  }
  placement_ = *placement;
}

// What errors of the calibration do to the points at rest and to the sample's axes.
void SpacePoints::tell_errors() {
  calibration_ = CalibrationError(views().cameras, views().covariance);
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    rest_errors_.push_back(calibration_.at(rest_[i].agreed.position, now_[i]->used));
  }
  const Eigen::Matrix3Xd positions = rest_positions();
  for (Eigen::Index mode = 0; mode < calibration_.modes(); ++mode) {
    Eigen::Matrix3Xd moved = positions;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      moved.col(static_cast<Eigen::Index>(i)) += rest_errors_[i].col(mode);
    }
    const auto placement =
        place_sample(moved, views().corners, calibration_.camera(0, mode), size());
    axes_errors_.push_back(placement ? placement->to_sample : placement_.to_sample);
  }
}

Eigen::Matrix3Xd SpacePoints::in_moved_axes(const Eigen::Vector3d& position,
                                            const Eigen::Matrix3Xd& errors) const {
  Eigen::Matrix3Xd off(3, errors.cols());
  for (Eigen::Index mode = 0; mode < errors.cols(); ++mode) {
    off.col(mode) = axes_errors_[static_cast<std::size_t>(mode)] * (position + errors.col(mode)) -
                    placement_.to_sample * position;
  }
  return off;
}

double SpacePoints::patch() const {
  const double pixel = (views().corners.col(1) - views().corners.col(0)).norm() +
                       (views().corners.col(3) - views().corners.col(0)).norm();
  return views().patch * placement_.sides.sum() / pixel;
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
    throw InputError({dic_.file_of(0)},
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
        "pictures of one moment, of cloth with an irregular pattern that does not repeat, by "
        "cameras that have not been exchanged, moved or refocused since they were calibrated");
  }
  if (rest.median_miss > kMostMiss || static_cast<double>(rest.points.size()) < kFewest * places) {
    refuse_calibration(
        dic_.file,
        fmt::format("what two cameras see of a point misses by {:.2g} pixels", rest.median_miss));
  }
}

std::vector<TagsByCode> SpacePoints::tags_in(const std::vector<GreyPicture>& pictures) const {
  if (dic_.fixed.empty() && dic_.label_codes().empty()) return {};
  return detect_tags(pictures, views().cameras, context_.threads);
}

void SpacePoints::begin_fixed(const std::vector<GreyPicture>& pictures,
                              const std::vector<TagsByCode>& tags) {
  if (dic_.fixed.empty()) return;
  for (std::size_t c = 0; c < pictures.size(); ++c) {
    fixed_.emplace_back(dic_.fixed, pictures[c], tags[c], views().files[c].front().string());
  }
}

std::string SpacePoints::moved_camera(const std::vector<TagsByCode>& tags) const {
  for (std::size_t c = 0; c < fixed_.size(); ++c) {
    const std::string doubt = fixed_[c].doubt(tags[c]);
    if (!doubt.empty()) return fmt::format("{} {}", views().names[c], doubt);
  }
  return {};
}

void SpacePoints::begin_cords(const std::vector<GreyPicture>& pictures) {
  if (!dic_.forces || dic_.forces->cells.empty()) return;
  cords_ = std::make_unique<SpaceCords>(dic_, placement_.to_sample.inverse(), rest_positions(),
                                        context_.threads);
  lines_ = cords_->follow(0, pictures, clips_).lines;
}

void SpacePoints::begin_views(std::vector<GreyPicture> pictures) {
  for (std::size_t c = 0; c < pictures.size(); ++c) {
    View view;
    view.tracker = std::make_unique<PatchTracker>(std::move(pictures[c]), views().patch / 2,
                                                  views().step, context_);
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const auto& seen = rest_[i].seen[c];
      if (seen && view.tracker->add(seen->pixel)) view.points.push_back(static_cast<int>(i));
    }
    view.check.emplace(*view.tracker);
    follow_.push_back(std::move(view));
    misses_.emplace_back(views().cameras[c].columns, views().cameras[c].rows);
  }
}

std::string SpacePoints::follow(int frame) {
  context_.stop.throw_if_requested();
  const std::vector<GreyPicture> now = pictures(frame);
  const std::vector<TagsByCode> tags = tags_in(now);
  if (labels_) {
    LabelledMotions motions = labels_->motions(tags);
    if (!motions.missing.empty()) {
      if (cords_) cords_->require_free(frame, motions.missing);
      return motions.missing;
    }
    clips_ = std::move(motions.clips);
  }
  if (cords_) {
    FrameCords cords = cords_->follow(frame, now, clips_);
    if (!cords.missing.empty()) return cords.missing;
    lines_ = std::move(cords.lines);
  }
  const std::vector<SeenPlaces> seen = seen_in(now);
  const double most = most_miss(rest_miss_);
  with_threads(context_.threads, [&] {
    parallel_for(static_cast<int>(rest_.size()), [&](int i) {
      const auto point = static_cast<std::size_t>(i);
      now_[point] = agreed_point(views().cameras, seen[point], most);
      if (now_[point]) sides_(i) = mean_side(seen[point], now_[point]->used);
    });
  });
  note_agreement(seen);
  note_misses(seen);
  matches_ = {};
  moved_ = moved_camera(tags);
  doubt_.clear();
  for (std::size_t c = 0; c < follow_.size(); ++c) {
    View& view = follow_[c];
    matches_.add(view.check->of(*view.tracker, context_.threads));
    view.noise.add(*view.tracker);
    const std::string doubt = picture_doubt(*view.tracker, now[c]);
    if (doubt_.empty() && !doubt.empty()) {
      doubt_ = fmt::format("the picture of {} {}", views().names[c], doubt);
    }
  }
  return "";
}

std::vector<SpacePoints::SeenPlaces> SpacePoints::seen_in(
    const std::vector<GreyPicture>& pictures) const {
  std::vector<SeenPlaces> seen(rest_.size(), SeenPlaces(follow_.size()));
  for (std::size_t c = 0; c < follow_.size(); ++c) {
    const View& view = follow_[c];
    view.tracker->follow(pictures[c]);
    for (std::size_t i = 0; i < view.points.size(); ++i) {
      const TrackedPatch& patch = view.tracker->patches()[i];
      if (!patch.is_seen) continue;
      const auto point = static_cast<std::size_t>(view.points[i]);
      const double noise = patch.noise();
      seen[point][c] = SeenPlace{patch.now(), std::hypot(noise, rest_[point].seen[c]->noise),
                                 view.tracker->side(patch)};
    }
  }
  return seen;
}

void SpacePoints::note_agreement(const std::vector<SeenPlaces>& seen) {
  int several = 0, agreeing = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const auto cameras =
        std::ranges::count_if(seen[i], [](const auto& place) { return place.has_value(); });
    if (cameras < 2) continue;
    ++several;
    agreeing += now_[i] && std::ranges::count(now_[i]->used, true) == cameras;
  }
  agreeing_ = several > 0 ? static_cast<double>(agreeing) / several : 1;
}

void SpacePoints::note_misses(const std::vector<SeenPlaces>& seen) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!now_[i]) continue;
    for (std::size_t c = 0; c < misses_.size(); ++c) {
      const auto expected = views().cameras[c].project(now_[i]->position);
      if (!now_[i]->used[c] || !expected) continue;
      const Eigen::Vector2d& pixel = seen[i][c]->pixel;
      misses_[c].add(pixel, pixel - *expected);
    }
  }
}

std::vector<PointsInPicture> SpacePoints::in_pictures(const Eigen::Matrix3Xd& points) const {
  const Eigen::Isometry3d to_rig = placement_.to_sample.inverse();
  std::vector<PointsInPicture> pictures;
  for (std::size_t c = 0; c < views().cameras.size(); ++c) {
    const CameraModel& camera = views().cameras[c];
    PointsInPicture picture{views().files[c][static_cast<std::size_t>(frame_)],
                            Eigen::Matrix2Xd::Constant(2, points.cols(), NAN)};
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if (!points.col(i).allFinite()) continue;
      const auto pixel = camera.project(to_rig * points.col(i));
      if (pixel) picture.pixels.col(i) = *pixel;
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

Pose SpacePoints::in_sample(const Pose& motion) const {
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.linear() = motion.rotation.toRotationMatrix();
  moved.translation() = motion.translation;
  const Eigen::Isometry3d own = placement_.to_sample * moved * placement_.to_sample.inverse();
  return {Eigen::Quaterniond(own.linear()).normalized(), own.translation()};
}

std::optional<CordLine> SpacePoints::in_sample(std::optional<CordLine> line) const {
  if (!line) return line;
  line->from = placement_.to_sample * line->from;
  line->direction = placement_.to_sample.linear() * line->direction;
  return line;
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
  for (const auto& line : lines_) points.cords.push_back(in_sample(line));
  std::vector<std::size_t> seen;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (now_[i]) seen.push_back(i);
  }
  points.rest.resize(3, std::ssize(seen));
  points.moved.resize(3, std::ssize(seen));
  points.patches = patch() / views().patch * sides_(seen);
  for (Eigen::Index k = 0; k < std::ssize(seen); ++k) {
    const std::size_t i = seen[static_cast<std::size_t>(k)];
    points.rest.col(k) = placement_.to_sample * rest_[i].agreed.position;
    points.moved.col(k) = placement_.to_sample * now_[i]->position;
  }
  points.deviations = deviations(seen, points);
  points.quality = quality();
  points.lost = static_cast<int>(rest_.size() - seen.size()) + lost_at_rest_;
  if (points.count() < kFewestPoints)
    points.left_out = "shows hardly a point on which two cameras agree";
  return points;
}

SightQuality SpacePoints::quality() const {
  SightQuality quality;
  quality.agreeing = agreeing_;
  std::vector<double> misses;
  std::vector<double> used(follow_.size(), 0);
  for (const auto& point : now_) {
    if (!point) continue;
    misses.push_back(point->miss);
    for (std::size_t c = 0; c < used.size(); ++c) used[c] += point->used[c] ? 1 : 0;
  }
  quality.miss = median(std::move(misses));
  quality.matches = matches_.quality();
  quality.moved = moved_;
  quality.doubt = doubt_;
  for (std::size_t c = 0; c < used.size(); ++c) {
    quality.share.push_back(used[c] / std::max(follow_[c].tracker->count(), 1));
  }
  return quality;
}

// A point that the calibration puts elsewhere at rest is taken for another place of the sample:
// what counts is by how much more, or less, it is put elsewhere now.
Eigen::Matrix3Xd SpacePoints::deviations(const std::vector<std::size_t>& seen,
                                         const PointFrame& points) const {
  constexpr double kReach = 3;  // spacings, over which the sample is stretched and turned evenly
  const double spacing = patch() * views().step / views().patch;
  const LocalMotion around(points.rest.topRows<2>(), points.moved, kReach * spacing);
  const Eigen::Matrix3d turn = placement_.to_sample.linear();
  Eigen::Matrix3Xd deviations(3, points.count());
  with_threads(context_.threads, [&] {
    parallel_for(points.count(), [&](int k) {
      const std::size_t i = seen[static_cast<std::size_t>(k)];
      const AgreedPoint& now = *now_[i];
      const auto local = around.at(points.rest.col(k).head<2>(), spacing);
      Eigen::Matrix<double, 3, 2> slope = Eigen::Matrix<double, 3, 2>::Identity();
      if (local) slope = local->slope;
      const Eigen::Matrix3Xd here =
          in_moved_axes(now.position, calibration_.at(now.position, now.used));
      const Eigen::Matrix3Xd at_rest = in_moved_axes(rest_[i].agreed.position, rest_errors_[i]);
      const Eigen::Matrix3Xd error = here - slope * at_rest.topRows<2>();
      const Eigen::Vector3d noise = (turn * now.covariance * turn.transpose()).diagonal();
      deviations.col(k) = (noise + error.rowwise().squaredNorm()).cwiseSqrt();
    });
  });
  return deviations;
}

std::vector<std::string> SpacePoints::notes() const {
  const auto length = [](double metres) { return format_quantity(metres, Dimension::length, 4); };
  return {fmt::format("{} points are seen by two cameras or more; their lines of sight miss each "
                      "other by {:.2g} pixels in the median",
                      rest_.size(), rest_miss_),
          fmt::format("by the cameras the sample's corners are {} x {} apart, where it is said to "
                      "be {} x {}",
                      length(placement_.sides.x()), length(placement_.sides.y()),
                      length(dic_.sample.width), length(dic_.sample.height))};
}

std::vector<std::string> SpacePoints::warnings() const {
  constexpr double kDoubtfulMiss = 0.2;  // pixels; cheap lenses miss by half of it
  std::vector<std::string> warnings = warnings_;
  if (rest_miss_ > kDoubtfulMiss) {
    warnings.push_back(fmt::format(
        "at rest lines of sight miss each other by {:.2g} pixels: was a camera moved or "
        "refocused since it was calibrated?",
        rest_miss_));
  }
  for (std::size_t c = 0; c < follow_.size(); ++c) {
    std::ranges::move(first_picture_warnings(*follow_[c].tracker, follow_[c].noise,
                                             views().files[c].front().string()),
                      std::back_inserter(warnings));
  }
  for (const Eigen::Index axis : {0, 1}) {
    const std::string doubt =
        size_doubt(placement_.sides(axis), size()(axis), axis == 0 ? "wide" : "high");
    if (!doubt.empty()) warnings.push_back(doubt);
  }
  if (labels_) std::ranges::move(labels_->warnings(), std::back_inserter(warnings));
  return warnings;
}

std::optional<Eigen::Vector3d> SpacePoints::gravity() const {
  if (!views().down) return std::nullopt;
  return kStandardGravity * (placement_.to_sample.linear() * *views().down).normalized();
}

}  // namespace pliant
