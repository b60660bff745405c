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

/// The turn that brings the warp upright on which labels agree.
/// @param labels  motions from their own axes into the plane
Eigen::Matrix3d axes_by_labels(const std::vector<SampleSide>& sides,
                               const std::vector<Eigen::Matrix3d>& labels) {
  Eigen::Vector2d warp = Eigen::Vector2d::Zero();
  for (std::size_t l = 0; l < labels.size(); ++l) {
    warp += warp_by(sides[l], labels[l].block<2, 1>(0, 1));
  }
  warp.normalize();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() << warp.y(), -warp.x(), warp.x(), warp.y();
  return turn;
}

struct Mean {
  double sum = 0;
  int count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  double value() const { return sum / count; }
};

/// What labels tell of the sample along weft or warp (m).
struct SampleEdges {
  Mean least, most;  // edges of clips at either side
  Mean middle;       // of all labels

  /// Where the sample begins: at an edge, or half way between the labels.
  double least_of(double size) const {
    if (least.count > 0) return least.value();
    return most.count > 0 ? most.value() - size : middle.value() - size / 2;
  }
  std::optional<double> length() const {
    if (least.count == 0 || most.count == 0) return std::nullopt;
    return most.value() - least.value();
  }
};

/// Along weft and along warp.
/// @param edge  from the middle of a label to the edge of its clip (m)
std::array<SampleEdges, 2> edges_by_labels(const std::vector<SampleSide>& sides,
                                           const std::vector<Eigen::Matrix3d>& labels,
                                           double edge) {
  std::array<SampleEdges, 2> edges;
  for (std::size_t l = 0; l < labels.size(); ++l) {
    const Eigen::Vector2d middle = moved(labels[l], Eigen::Vector2d::Zero());
    edges[0].middle.add(middle.x());
    edges[1].middle.add(middle.y());
    const int axis = axis_of(sides[l]);
    SampleEdges& along = edges[static_cast<std::size_t>(axis)];
    (is_least(sides[l]) ? along.least : along.most)
        .add(moved(labels[l], Eigen::Vector2d(0, -edge))(axis));
  }
  return edges;
}

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

/// Where a pinhole would show the corners of a tag.
Corners straight_corners(const DetectedTag& tag, const Lens& lens) {
  const auto& camera = lens.camera();
  return lens.straightened(camera ? tag.corners_by(*camera) : tag.corners);
}

}  // namespace

LabelViews::LabelViews(const DicFile& dic, const GreyPicture& first) : dic_(dic), lens_(dic.lens) {
  const std::vector<DetectedTag> found = detect_tags(first);
  const TagsByCode tags = tags_by_code(found);
  const std::string file = dic.file_of(0);
  std::vector<LabelSighting> sightings;
  for (std::size_t clip = 0; clip < dic.clips.size(); ++clip) {
    for (const int code : dic.clips[clip].labels) {
      if (!tags.once.contains(code)) {
        const bool is_twice = tags.twice.contains(code);
        if (!is_twice) require_unmirrored(first, dic.label_codes(), file);
        throw InputError(
            {file},
            fmt::format("shows the label {} of the clip {} {} (labels found: {})", code,
                        dic.clips[clip].name, is_twice ? "more than once" : "not at all",
                        codes_text(found)),
            "each label once in the first picture, whole, in focus and with some white "
            "around it");
      }
      const Corners rest = corners_of_label(dic.labels->tag);
      sightings.push_back(
          {rest, straight_corners(tags.once.at(code), lens_), static_cast<int>(labels_.size())});
      labels_.push_back({clip, code, rest});
    }
    if (!dic.clips[clip].labels.empty()) carriers_.push_back(clip);
  }
  place_sample(fit_plane(sightings, static_cast<int>(labels_.size())));
}

// The first label's axes are those of the fit. The sample's follow from where the labels point, and
// from the edges of the clips.
void LabelViews::place_sample(const PlaneFit& fit) {
  std::vector<SampleSide> sides;
  std::vector<Eigen::Matrix3d> labels;
  for (const Label& label : labels_) {
    sides.push_back(dic_.clips[label.clip].side);
    labels.push_back(in_plane(fit.bodies[labels.size()]));
  }
  const Eigen::Matrix3d turn = axes_by_labels(sides, labels);
  for (Eigen::Matrix3d& label : labels) label = turn * label;
  const std::array<SampleEdges, 2> edges = edges_by_labels(sides, labels, dic_.labels->edge);
  const Eigen::Vector2d size(dic_.sample.width, dic_.sample.height);
  Eigen::Vector2d corner(edges[0].least_of(size.x()), edges[1].least_of(size.y()));
  for (const std::size_t axis : {0U, 1U}) lengths_[axis] = edges[axis].length();

  first_.lens = lens_;
  first_.miss = fit.miss;
  first_.clips.resize(dic_.clips.size());
  first_.to_plane = turn * fit.to_picture.inverse();
  if (dic_.labels->corner) corner = first_.on_plane(*dic_.labels->corner);
  Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
  shift.topRightCorner<2, 1>() = -corner;
  first_.to_plane = shift * first_.to_plane;
  for (std::size_t l = 0; l < labels_.size(); ++l) {
    labels_[l].corners = moved(shift * labels[l], labels_[l].corners);
    first_.clips[labels_[l].clip] = Pose{};
  }
}

SeenLabels LabelViews::of(const GreyPicture& picture) const {
  const TagsByCode tags = tags_by_code(detect_tags_of(dic_.label_codes(), picture));
  std::vector<LabelSighting> sightings;
  std::vector<char> is_seen(carriers_.size(), 0);
  for (const Label& label : labels_) {
    if (tags.twice.contains(label.code))
      return {{}, fmt::format("shows the label {} more than once", label.code)};
    const auto tag = tags.once.find(label.code);
    if (tag == tags.once.end()) continue;
    const auto body =
        static_cast<std::size_t>(std::ranges::find(carriers_, label.clip) - carriers_.begin());
    is_seen[body] = 1;
    sightings.push_back(
        {label.corners, straight_corners(tag->second, lens_), static_cast<int>(body)});
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
