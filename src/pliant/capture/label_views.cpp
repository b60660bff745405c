#include "pliant/capture/label_views.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/capture/tag_detector.h"

namespace pliant {
namespace {

using Corners = Eigen::Matrix<double, 2, 4>;

/// In the label's own axes, in the order of `DetectedTag`.
Corners corners_of_label(double side) {
  Corners corners;
  corners << -1, 1, 1, -1,  //
      -1, -1, 1, 1;
  return corners * side / 2;
}

/// A motion of the plane as a matrix of homogeneous coordinates.
Eigen::Matrix3d in_plane(const Pose& pose) {
  Eigen::Matrix3d matrix = pose.rotation.toRotationMatrix();
  matrix.topRightCorner<2, 1>() = pose.translation.head<2>();
  return matrix;
}

Eigen::Matrix2Xd moved(const Eigen::Matrix3d& matrix, const Eigen::Matrix2Xd& places) {
  return (matrix * places.colwise().homogeneous()).colwise().hnormalized();
}

/// The direction of warp that a label shows: its own y axis points away from the sample.
Eigen::Vector2d warp_by(SampleSide side, const Eigen::Vector2d& outward) {
  switch (side) {
    case SampleSide::bottom:
      return -outward;
    case SampleSide::top:
      return outward;
    case SampleSide::left:
      return {outward.y(), -outward.x()};
    case SampleSide::right:
      break;
  }
  return {-outward.y(), outward.x()};
}

/// The coordinate of a side along weft (0) or warp (1), and whether it is the least.
int axis_of(SampleSide side) {
  return side == SampleSide::bottom || side == SampleSide::top ? 1 : 0;
}
bool is_least(SampleSide side) { return side == SampleSide::bottom || side == SampleSide::left; }

std::string codes_text(const std::vector<DetectedTag>& tags) {
  if (tags.empty()) return "none";
  std::string text;
  for (const DetectedTag& tag : tags)
    text += fmt::format("{}{}", text.empty() ? "" : ", ", tag.code);
  return text;
}

/// Depths along the camera's axis, of a place beside another one.
double depth_ratio(const PlaneView& view, const Eigen::Vector2d& place,
                   const Eigen::Vector2d& other) {
  const Eigen::RowVector3d depth = view.to_plane.inverse().row(2);
  return depth.dot(place.homogeneous()) / depth.dot(other.homogeneous());
}

}  // namespace

LabelViews::LabelViews(const DicFile& dic, const GreyPicture& first) : dic_(dic), lens_(dic.lens) {
  const std::vector<DetectedTag> tags = detect_tags(first);
  std::vector<LabelSighting> sightings;
  for (std::size_t clip = 0; clip < dic.clips.size(); ++clip) {
    for (const int code : dic.clips[clip].labels) {
      const auto count = std::ranges::count(tags, code, &DetectedTag::code);
      if (count != 1) {
        throw InputError(
            {dic.pictures->files.front().string()},
            fmt::format("shows the label {} of the clip {} {} (labels found: {})", code,
                        dic.clips[clip].name,
                        count == 0 ? "not at all" : fmt::format("{} times", count),
                        codes_text(tags)),
            "each label once in the first picture, whole, in focus and with some white "
            "around it");
      }
      const Corners rest = corners_of_label(dic.labels->tag);
      sightings.push_back({rest, straight_corners(tags, code), static_cast<int>(labels_.size())});
      labels_.push_back({clip, code, rest});
    }
    if (!dic.clips[clip].labels.empty()) carriers_.push_back(clip);
  }
  place_sample(fit_plane(sightings, static_cast<int>(labels_.size())));
}

// The first label's axes are those of the fit. The sample's follow from where the labels point, and
// from the edges of the clips.
void LabelViews::place_sample(const PlaneFit& fit) {
  Eigen::Vector2d warp = Eigen::Vector2d::Zero();
  for (std::size_t l = 0; l < labels_.size(); ++l) {
    warp += warp_by(dic_.clips[labels_[l].clip].side, in_plane(fit.bodies[l]).block<2, 1>(0, 1));
  }
  warp.normalize();
  Eigen::Matrix3d to_sample = Eigen::Matrix3d::Identity();
  to_sample.topLeftCorner<2, 2>() << warp.y(), -warp.x(), warp.x(), warp.y();

  // Means over the labels of a side, of the clips' edges and of the labels' middles across.
  std::array<std::array<double, 2>, 2> edges{}, counts{};  // by axis, least and most
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (std::size_t l = 0; l < labels_.size(); ++l) {
    const Eigen::Matrix3d label = to_sample * in_plane(fit.bodies[l]);
    const SampleSide side = dic_.clips[labels_[l].clip].side;
    const auto axis = static_cast<std::size_t>(axis_of(side)),
               end = static_cast<std::size_t>(!is_least(side));
    const Eigen::Vector2d edge = moved(label, Eigen::Vector2d(0, -dic_.labels->edge));
    edges[axis][end] += edge(axis_of(side));
    counts[axis][end] += 1;
    middle += moved(label, Eigen::Vector2d::Zero()) / static_cast<double>(labels_.size());
  }
  const Eigen::Vector2d size(dic_.sample.width, dic_.sample.height);
  Eigen::Vector2d corner = middle - size / 2;
  for (const std::size_t axis : {0U, 1U}) {
    const auto [first, last] = counts[axis];
    const double least = edges[axis][0] / first, most = edges[axis][1] / last;
    const auto place = static_cast<Eigen::Index>(axis);
    if (last > 0) corner(place) = most - size(place);
    if (first > 0) corner(place) = least;
    if (first > 0 && last > 0) lengths_[axis] = most - least;
  }
  first_.lens = lens_;
  first_.to_plane = to_sample * fit.to_picture.inverse();
  if (dic_.labels->corner) corner = first_.on_plane(*dic_.labels->corner);
  Eigen::Matrix3d to_corner = Eigen::Matrix3d::Identity();
  to_corner.topRightCorner<2, 1>() = -corner;
  first_.to_plane = to_corner * first_.to_plane;
  first_.miss = fit.miss;
  first_.clips.resize(dic_.clips.size());
  for (std::size_t l = 0; l < labels_.size(); ++l) {
    labels_[l].corners = moved(to_corner * to_sample * in_plane(fit.bodies[l]), labels_[l].corners);
    first_.clips[labels_[l].clip] = Pose{};
  }
}

Eigen::Matrix<double, 2, 4> LabelViews::straight_corners(const std::vector<DetectedTag>& tags,
                                                         int code) const {
  return lens_.straightened(std::ranges::find(tags, code, &DetectedTag::code)->corners);
}

SeenLabels LabelViews::of(const GreyPicture& picture) const {
  const std::vector<DetectedTag> tags = detect_tags(picture);
  std::vector<LabelSighting> sightings;
  std::vector<char> is_seen(carriers_.size(), 0);
  for (const Label& label : labels_) {
    const auto count = std::ranges::count(tags, label.code, &DetectedTag::code);
    if (count > 1) return {{}, fmt::format("shows the label {} {} times", label.code, count)};
    if (count == 0) continue;
    const auto body =
        static_cast<std::size_t>(std::ranges::find(carriers_, label.clip) - carriers_.begin());
    is_seen[body] = 1;
    sightings.push_back(
        {label.corners, straight_corners(tags, label.code), static_cast<int>(body)});
  }
  for (std::size_t body = 0; body < carriers_.size(); ++body) {
    if (is_seen[body] == 0)
      return {{}, fmt::format("shows no label of the clip {}", dic_.clips[carriers_[body]].name)};
  }
  const PlaneFit fit = fit_plane(sightings, static_cast<int>(carriers_.size()));
  PlaneView view;
  view.lens = lens_;
  view.to_plane = fit.to_picture.inverse();
  view.miss = fit.miss;
  view.clips.resize(dic_.clips.size());
  const auto middle_of = [&](std::size_t clip) -> Eigen::Vector2d {
    return std::ranges::find(labels_, clip, &Label::clip)->corners.rowwise().mean();
  };
  const Eigen::Vector2d stays = middle_of(carriers_.front());
  for (std::size_t body = 0; body < carriers_.size(); ++body) {
    view.clips[carriers_[body]] = fit.bodies[body];
    const Eigen::Vector2d rest = middle_of(carriers_[body]);
    const Eigen::Vector2d now = moved(in_plane(fit.bodies[body]), rest);
    const double nearer = depth_ratio(first_, rest, stays) / depth_ratio(view, now, stays) - 1;
    if (std::abs(nearer) > std::abs(view.nearer)) view.nearer = nearer;
  }
  return {view, ""};
}

}  // namespace pliant
