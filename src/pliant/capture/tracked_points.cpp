#include "pliant/capture/tracked_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/median.h"

namespace pliant {
namespace {

constexpr double kAlike = 0.75;           // correlation of a patch that was found
constexpr double kRounding = 1e-6;        // of a pixel
constexpr int kFewestFound = 5;           // that say where others have gone
constexpr double kNear = 2.3, kWide = 8;  // reach of patches that lead others, in steps

/// The sample's corners in the plane that pictures show (m), one after the other.
Eigen::Matrix<double, 2, 4> sample_corners(const DicFile& dic) {
  const auto along = [](const PointAxis& axis, double size) -> Eigen::Vector2d {
    return axis.sign * size * Eigen::Vector2d::Unit(axis.axis);
  };
  const Eigen::Vector2d weft = along(dic.weft, dic.sample.width);
  const Eigen::Vector2d warp = along(dic.warp, dic.sample.height);
  Eigen::Matrix<double, 2, 4> corners;
  corners << Eigen::Vector2d::Zero(), weft, weft + warp, warp;
  return corners.colwise() + *dic.origin;
}

/// Whether a place lies on the sample with a margin around it.
/// @param corners  of the sample (pixels), one after the other
bool is_inside(const Eigen::Matrix<double, 2, 4>& corners, const Eigen::Vector2d& place,
               double margin) {
  const auto left_of = [&](int k) {  // how far the place is left of a side
    const Eigen::Vector2d side = corners.col((k + 1) % 4) - corners.col(k);
    const Eigen::Vector2d way = place - corners.col(k);
    return (side.x() * way.y() - side.y() * way.x()) / side.norm();
  };
  double least = INFINITY, most = -INFINITY;
  for (int k = 0; k < 4; ++k) {
    least = std::min(least, left_of(k));
    most = std::max(most, left_of(k));
  }
  // All on one side, whichever way round the corners go.
  return least >= margin || most <= -margin;
}

}  // namespace

GreyPicture reduced(const GreyPicture& picture, int factor) {
  GreyPicture result(picture.rows() / factor, picture.cols() / factor);
  for (Eigen::Index row = 0; row < result.rows(); ++row) {
    for (Eigen::Index column = 0; column < result.cols(); ++column) {
      result(row, column) = picture.block(row * factor, column * factor, factor, factor).mean();
    }
  }
  return result;
}

std::optional<Eigen::Vector2i> coarse_shift(const GreyPicture& rest, const GreyPicture& now,
                                            const Eigen::Vector2i& place, int radius, int reach) {
  constexpr float kLeast = 0.5;
  const int side = 2 * radius + 1;
  const auto within = [&](const GreyPicture& picture, const Eigen::Vector2i& middle) {
    return middle.x() >= radius && middle.y() >= radius && middle.x() + radius < picture.cols() &&
           middle.y() + radius < picture.rows();
  };
  const auto patch_at = [&](const GreyPicture& picture, const Eigen::Vector2i& middle) {
    GreyPicture patch = picture.block(middle.y() - radius, middle.x() - radius, side, side);
    patch -= patch.mean();
    return patch;
  };
  if (!within(rest, place)) return std::nullopt;
  const GreyPicture patch = patch_at(rest, place);
  const float norm = patch.matrix().norm();
  std::optional<Eigen::Vector2i> best;
  float most = kLeast;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const Eigen::Vector2i shift(x, y);
      if (!within(now, place + shift)) continue;
      const GreyPicture other = patch_at(now, place + shift);
      const float correlation = (patch * other).sum() / (norm * other.matrix().norm());
      if (!(correlation > most)) continue;
      most = correlation;
      best = shift;
    }
  }
  return best;
}

TrackedPoints::TrackedPoints(const DicFile& dic, ReadPicture read_picture,
                             const RunContext& context)
    : dic_(dic), read_picture_(std::move(read_picture)), context_(context) {
  rest_ = picture(0);
  if (dic_.labels) {
    labels_ = std::make_unique<LabelViews>(dic_, rest_);
    first_ = labels_->first();
  } else {
    first_ = straight_view(*dic_.scale);
  }
  now_ = first_;
  place_patches(SplinePicture(rest_, kMatchSmoothing));
}

std::string TrackedPoints::file(int frame) const {
  return dic_.pictures->files[static_cast<std::size_t>(frame)].string();
}

GreyPicture TrackedPoints::picture(int frame) const {
  GreyPicture read = read_picture_(dic_.pictures->files[static_cast<std::size_t>(frame)]);
  const auto& camera = dic_.lens.camera();
  if (camera && (read.rows() != camera->rows || read.cols() != camera->columns)) {
    throw InputError({file(frame)},
                     fmt::format("is {} x {} pixels, and those of its camera's calibration {} x {}",
                                 read.cols(), read.rows(), camera->columns, camera->rows),
                     "pictures of that camera, neither cut nor turned nor made smaller");
  }
  if (frame > 0 && (read.rows() != rest_.rows() || read.cols() != rest_.cols())) {
    throw InputError({file(frame)},
                     fmt::format("is {} x {} pixels, and the first picture {} x {}", read.cols(),
                                 read.rows(), rest_.cols(), rest_.rows()),
                     "pictures of one camera that does not move");
  }
  return read;
}

void TrackedPoints::place_patches(const SplinePicture& rest) {
  const int radius = dic_.pictures->patch / 2, step = dic_.pictures->step;
  const Eigen::Matrix<double, 2, 4> corners = first_.in_picture(sample_corners(dic_));
  const Eigen::Vector2d least = corners.rowwise().minCoeff(), most = corners.rowwise().maxCoeff();
  if (!rest.contains(least) || !rest.contains(most)) {
    throw InputError(
        {dic_.file, 0, "sample"},
        fmt::format("lies at columns {:.0f} to {:.0f} and rows {:.0f} to {:.0f} of a "
                    "picture of {} x {}",
                    least.x(), most.x(), least.y(), most.y(), rest.columns(), rest.rows()),
        dic_.labels ? "a sample within the first picture: its size and the labels tell where it is"
                    : "a sample within the first picture: its size, `origin`, `scale`, `weft` and "
                      "`warp` tell where it is");
  }
  int places = 0;
  const Eigen::Vector2i from = (least.array() + radius + 1).ceil().cast<int>();
  const Eigen::Vector2i to = (most.array() - radius - 1).floor().cast<int>();
  for (int y = from.y(); y <= to.y(); y += step) {
    for (int x = from.x(); x <= to.x(); x += step) {
      const Eigen::Vector2d place(x, y);
      if (!is_inside(corners, place, radius + 1 - kRounding)) continue;
      ++places;
      if (auto patch = ReferencePatch::of(rest, place, radius)) {
        tracked_.push_back({place, *std::move(patch), {}});
      }
    }
  }
  without_texture_ = places - static_cast<int>(tracked_.size());
  if (places == 0 || 2 * without_texture_ > places) {
    throw InputError({file(0)},
                     fmt::format("{} of {} patches of the sample have no texture to be found again",
                                 without_texture_, places),
                     "a sample with a fine irregular pattern all over, in focus");
  }
}

std::vector<std::string> TrackedPoints::notes() const {
  if (!labels_) return {};
  std::vector<std::string> notes;
  const Eigen::Vector2d size(dic_.sample.width, dic_.sample.height);
  for (const std::size_t axis : {0U, 1U}) {
    if (!labels_->lengths()[axis]) continue;
    notes.push_back(fmt::format(
        "the labels say that the clips' edges are {} apart at rest, where the sample is said to be "
        "{} {}",
        format_quantity(*labels_->lengths()[axis], Dimension::length, 4),
        format_quantity(size(static_cast<Eigen::Index>(axis)), Dimension::length, 4),
        axis == 0 ? "wide" : "high"));
  }
  if (views_ > 0) {
    notes.push_back(fmt::format("corners of labels miss the view of a plane by {:.2g} pixels",
                                std::sqrt(label_squares_ / views_)));
  }
  return notes;
}

int TrackedPoints::seen() const {
  return static_cast<int>(std::ranges::count_if(tracked_, &Tracked::is_seen));
}

PointFrame TrackedPoints::read(int frame) {
  if (frame != frame_) {
    frame_ = frame;
    std::string missing = track(frame);
    if (!missing.empty()) {
      PointFrame none;
      none.left_out = std::move(missing);
      return none;
    }
  }
  return points();
}

// Says what the picture lacks, or nothing.
std::string TrackedPoints::track(int frame) {
  context_.stop.throw_if_requested();
  const GreyPicture grey = picture(frame);
  if (labels_) {
    SeenLabels seen = labels_->of(grey);
    if (!seen.view) return seen.missing;
    now_ = *std::move(seen.view);
    label_squares_ += now_.miss * now_.miss;
    ++views_;
  }
  const SplinePicture now(grey, kMatchSmoothing);
  match_where_they_were(now);
  if (2 * seen() < static_cast<int>(tracked_.size())) search_far(grey, now);
  while (match_beside_found(now, kNear) || match_beside_found(now, kWide)) {
  }
  leave_out_strays();
  return "";
}

void TrackedPoints::look_for(Tracked& point, const SplinePicture& now,
                             const PatchMotion& start) const {
  const auto match = point.patch.match(now, start);
  point.is_seen = match && match->correlation > kAlike;
  if (!point.is_seen) return;
  point.motion = match->motion;
  point.correlation = match->correlation;
}

void TrackedPoints::match_where_they_were(const SplinePicture& now) {
  with_threads(context_.threads, [&] {
    parallel_for(static_cast<int>(tracked_.size()), [&](int i) {
      Tracked& point = tracked_[static_cast<std::size_t>(i)];
      look_for(point, now, point.motion);
    });
  });
}

TrackedPoints::Found TrackedPoints::found() const {
  Found found{Eigen::Matrix2Xd(2, seen()), Eigen::Matrix2Xd(2, seen())};
  Eigen::Index next = 0;
  for (const Tracked& point : tracked_) {
    if (!point.is_seen) continue;
    found.rest.col(next) = point.place;
    found.now.col(next++) = point.place + point.motion.shift;
  }
  return found;
}

LocalMotion TrackedPoints::motion_of_found(double reach) const {
  const Found places = found();
  Eigen::Matrix3Xd now = Eigen::Matrix3Xd::Zero(3, places.now.cols());
  now.topRows<2>() = places.now;
  return {places.rest, now, reach};
}

// Looks for what is lost where the patches around it say; whether more was found.
bool TrackedPoints::match_beside_found(const SplinePicture& now, double steps) {
  const double reach = steps * dic_.pictures->step;
  const int before = seen();
  if (before < kFewestFound || before == static_cast<int>(tracked_.size())) return false;
  const LocalMotion around = motion_of_found(reach);
  with_threads(context_.threads, [&] {
    parallel_for(static_cast<int>(tracked_.size()), [&](int i) {
      Tracked& point = tracked_[static_cast<std::size_t>(i)];
      if (point.is_seen) return;
      const auto moved = around.at(point.place, reach);
      if (!moved) return;
      const PatchMotion start{moved->position.head<2>() - point.place,
                              moved->slope.topRows<2>() - Eigen::Matrix2d::Identity()};
      look_for(point, now, start);
    });
  });
  return seen() > before;
}

// Searches for some patches in reduced pictures; what is found there is refined in them, and then
// in the pictures themselves.
void TrackedPoints::search_far(const GreyPicture& grey, const SplinePicture& now) {
  constexpr int kFactor = 4, kRadius = 8, kReach = 40, kSeeds = 40;
  const GreyPicture rest = reduced(rest_, kFactor), moved = reduced(grey, kFactor);
  const SplinePicture rest_spline(rest), moved_spline(moved);
  for (Tracked& point : tracked_) point.is_seen = false;  // what was found may be anything
  const std::size_t every = std::max<std::size_t>(tracked_.size() / kSeeds, 1);
  with_threads(context_.threads, [&] {
    parallel_for(static_cast<int>(tracked_.size() / every), [&](int seed) {
      Tracked& point = tracked_[static_cast<std::size_t>(seed) * every];
      // The middle of the first pixel of a square is half a square off the square's.
      const Eigen::Vector2d place = (point.place.array() - (kFactor - 1) / 2.0).matrix() / kFactor;
      const auto patch = ReferencePatch::of(rest_spline, place, kRadius);
      const auto shift =
          coarse_shift(rest, moved, place.array().round().cast<int>(), kRadius, kReach);
      if (!patch || !shift) return;
      const auto coarse = patch->match(moved_spline, {.shift = shift->cast<double>()});
      if (!coarse || coarse->correlation < kAlike) return;
      look_for(point, now,
               {.shift = kFactor * coarse->motion.shift, .slope = coarse->motion.slope});
    });
  });
}

void TrackedPoints::leave_out_strays() {
  constexpr double kTimes = 8;                    // the median
  constexpr double kLeast = 0.1, kUnlike = 0.02;  // pixels; of what two patches do not share
  const double reach = kNear * dic_.pictures->step;
  if (seen() < kFewestFound) return;
  const LocalMotion around = motion_of_found(reach);
  std::vector<double> off, unlike;  // of the points that were seen
  for (const Tracked& point : tracked_) {
    if (!point.is_seen) continue;
    const auto moved = around.at(point.place, reach);
    off.push_back(moved ? (moved->position.head<2>() - point.place - point.motion.shift).norm()
                        : INFINITY);
    unlike.push_back(1 - point.correlation);
  }
  const double most_off = std::max(kTimes * median(off), kLeast);
  const double most_unlike = std::max(kTimes * median(unlike), kUnlike);
  std::size_t next = 0;
  for (Tracked& point : tracked_) {
    if (!point.is_seen) continue;
    point.is_seen = off[next] <= most_off && unlike[next] <= most_unlike;
    ++next;
  }
}

PointFrame TrackedPoints::points() const {
  const Found places = found();
  PointFrame frame;
  frame.rest = Eigen::Matrix3Xd::Zero(3, places.rest.cols());
  frame.moved = frame.rest;
  frame.rest.topRows<2>() = first_.on_plane(places.rest);
  frame.moved.topRows<2>() = now_.on_plane(places.now);
  frame.lost = static_cast<int>(tracked_.size()) - seen() + without_texture_;
  frame.clips = now_.clips;
  frame.nearer = now_.nearer;
  return frame;
}

}  // namespace pliant
