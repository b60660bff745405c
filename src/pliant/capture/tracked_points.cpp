#include "pliant/capture/tracked_points.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/camera_picture.h"
#include "pliant/capture/picture_doubt.h"
#include "pliant/capture/quadrilateral.h"
#include "pliant/capture/repeating_texture.h"
#include "pliant/capture/sample_placement.h"

namespace pliant {
namespace {

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

}  // namespace

TrackedPoints::TrackedPoints(const DicFile& dic, ReadPicture read_picture,
                             const RunContext& context)
    : dic_(dic), read_picture_(std::move(read_picture)), context_(context) {
  GreyPicture rest = picture(0);
  if (dic_.labels) {
    labels_ = std::make_unique<LabelViews>(dic_, rest);
    first_ = labels_->first();
    require_size();
  } else {
    first_ = straight_view(*dic_.scale);
  }
  now_ = first_;
  if (!dic_.fixed.empty())
    fixed_.emplace(dic_.fixed, rest, tags_by_code(detect_tags(rest)), dic_.file_of(0));
  const DicPictures& pictures = *dic_.pictures;
  tracker_ =
      std::make_unique<PatchTracker>(std::move(rest), pictures.patch / 2, pictures.step, context_);
  place_patches();
  check_.emplace(*tracker_);
  warnings_ = repeat_warnings(tracker_->first(), tracker_->found().places, context_.threads);
  for (const auto& [which, seen, stated] : sizes_by_labels()) {
    const std::string doubt = size_doubt(seen, stated, which);
    if (!doubt.empty()) warnings_.push_back(doubt);
  }
}

std::vector<std::string> TrackedPoints::warnings() const {
  std::vector<std::string> warnings = warnings_;
  std::ranges::move(first_picture_warnings(*tracker_, noise_, dic_.file_of(0)),
                    std::back_inserter(warnings));
  return warnings;
}

std::vector<TrackedPoints::LabelledSize> TrackedPoints::sizes_by_labels() const {
  std::vector<LabelledSize> sizes;
  if (!labels_) return sizes;
  const auto& [width, height] = labels_->lengths();
  if (width) sizes.push_back({"wide", *width, dic_.sample.width});
  if (height) sizes.push_back({"high", *height, dic_.sample.height});
  return sizes;
}

// Labels that are not told from their reflection put the edges of clips on their wrong side.
void TrackedPoints::require_size() const {
  for (const auto& [which, seen, stated] : sizes_by_labels()) {
    if (seen > stated / 2 && seen < 2 * stated) continue;
    throw InputError(
        {dic_.file, 0, "labels"},
        fmt::format("say that the clips' edges are {} apart, where the sample is said to be {} {}",
                    format_quantity(seen, Dimension::length, 4),
                    format_quantity(stated, Dimension::length, 4), which),
        "labels that point away from the sample, their size as it was printed, and the sample's");
  }
}

double TrackedPoints::patch() const {
  const Eigen::Vector2d middle = tracker_->patches().front().place;
  Eigen::Matrix2d pixel;
  pixel << middle, middle + Eigen::Vector2d::UnitX();
  const Eigen::Matrix2Xd on_plane = first_.on_plane(pixel);
  return dic_.pictures->patch * (on_plane.col(1) - on_plane.col(0)).norm();
}

GreyPicture TrackedPoints::picture(int frame) const {
  const auto& path = dic_.pictures->files[static_cast<std::size_t>(frame)];
  const auto& camera = dic_.lens.camera();
  GreyPicture read =
      camera ? read_camera_picture(read_picture_, path, *camera) : read_picture_(path);
  if (frame == 0) return read;
  const GreyPicture& rest = tracker_->first();
  if (read.rows() != rest.rows() || read.cols() != rest.cols()) {
    throw InputError({dic_.file_of(frame)},
                     fmt::format("is {} x {} pixels, and the first picture {} x {}", read.cols(),
                                 read.rows(), rest.cols(), rest.rows()),
                     "pictures of one camera that does not move");
  }
  return read;
}

void TrackedPoints::place_patches() {
  const DicPictures& pictures = *dic_.pictures;
  const Quadrilateral corners = first_.in_picture(sample_corners(dic_));
  const Eigen::Vector2d least = corners.rowwise().minCoeff(), most = corners.rowwise().maxCoeff();
  const GreyPicture& rest = tracker_->first();
  const Eigen::Vector2d last(rest.cols() - 1, rest.rows() - 1);
  if (least.minCoeff() < 0 || (last - most).minCoeff() < 0) {
    throw InputError(
        {dic_.file, 0, "sample"},
        fmt::format("lies at columns {:.0f} to {:.0f} and rows {:.0f} to {:.0f} of a "
                    "picture of {} x {}",
                    least.x(), most.x(), least.y(), most.y(), rest.cols(), rest.rows()),
        dic_.labels ? "a sample within the first picture: its size and the labels tell where it is"
                    : "a sample within the first picture: its size, `origin`, `scale`, `weft` and "
                      "`warp` tell where it is");
  }
  const auto places = places_within(corners, pictures.step, pictures.patch / 2 + 1);
  for (const Eigen::Vector2d& place : places) {
    if (!tracker_->add(place)) ++without_texture_;
  }
  if (places.empty() || 2 * without_texture_ > std::ssize(places)) {
    throw InputError({dic_.file_of(0)},
                     fmt::format("{} of {} patches of the sample have no texture to be found again",
                                 without_texture_, places.size()),
                     "a sample with a fine irregular pattern all over, in focus");
  }
}

std::vector<std::string> TrackedPoints::notes() const {
  if (!labels_) return {};
  std::vector<std::string> notes;
  for (const auto& [which, seen, stated] : sizes_by_labels()) {
    notes.push_back(fmt::format(
        "the labels say that the clips' edges are {} apart at rest, where the sample is said to be "
        "{} {}",
        format_quantity(seen, Dimension::length, 4), format_quantity(stated, Dimension::length, 4),
        which));
  }
  if (views_ > 0) {
    notes.push_back(fmt::format("corners of labels miss the view of a plane by {:.2g} pixels",
                                std::sqrt(label_squares_ / views_)));
  }
  return notes;
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
  tracker_->follow(grey);
  matches_ = check_->of(*tracker_, context_.threads);
  noise_.add(*tracker_);
  const auto of_picture = [](const std::string& doubt) {
    return doubt.empty() ? doubt : "its picture " + doubt;
  };
  doubt_ = of_picture(picture_doubt(*tracker_, grey));
  if (fixed_) moved_ = of_picture(fixed_->doubt(tags_by_code(detect_tags(grey))));
  const bool is_seen = tracker_->seen() >= kFewestPoints;
  return is_seen ? "" : "shows hardly a square of the sample that is found again";
}

PointFrame TrackedPoints::points() const {
  const FoundPatches found = tracker_->found();
  PointFrame frame;
  frame.rest = Eigen::Matrix3Xd::Zero(3, found.now.cols());
  frame.moved = frame.rest;
  frame.rest.topRows<2>() = first_.on_plane(found.places);
  frame.moved.topRows<2>() = now_.on_plane(found.now);
  frame.patches.setZero(frame.rest.cols());
  frame.lost = tracker_->count() - frame.count() + without_texture_;
  frame.clips = now_.clips;
  frame.nearer = now_.nearer;
  const double tracked = std::max(tracker_->count(), 1);
  SightQuality& quality = frame.quality.emplace();
  quality.share = {frame.count() / tracked};
  quality.matches = matches_.quality();
  quality.moved = moved_;
  quality.doubt = doubt_;
  if (labels_) quality.miss = now_.miss;
  return frame;
}

std::vector<PointsInPicture> TrackedPoints::in_pictures(const Eigen::Matrix3Xd& points) const {
  return {{dic_.pictures->files[static_cast<std::size_t>(frame_)],
           now_.in_picture(points.topRows<2>())}};
}

}  // namespace pliant
