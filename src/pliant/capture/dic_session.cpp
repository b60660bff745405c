#include "pliant/capture/dic_session.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/clip_motion.h"
#include "pliant/capture/frame_doubts.h"
#include "pliant/capture/frame_forces.h"
#include "pliant/capture/local_motion.h"
#include "pliant/capture/point_source.h"
#include "pliant/capture/rest_places.h"
#include "pliant/capture/sample_axes.h"
#include "pliant/capture/seen_vertices.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/measurement/session/clip_grid.h"

namespace pliant {
namespace {

constexpr double kEdge = 2;  // of the mesh, in spacings of the points
constexpr double kFar = 6;   // points that tell a clip
constexpr std::size_t kMostVertices = 40000;

/// Follows the sheet from frame to frame.
class SheetFollower {
 public:
  SheetFollower(const DicFile& dic, const ReadPicture& read_picture, const RunContext& context)
      : dic_(dic), context_(context), points_(point_source(dic, read_picture, context)) {
    const PointFrame first = read(0);
    axes_ = sample_axes(dic, first.rest);
    result_.off_plane = axes_.off_plane;
    result_.spacing = point_spacing(axes_.of(first.rest).topRows<2>());
    const Eigen::Vector2d size(dic.sample.width, dic.sample.height);
    places_.emplace(axes_, first.rest, size, result_.spacing);
    result_.unrolled = places_->stretch();
    places_->require_sheet(dic_.file_of(0));
    vertices_.emplace(result_.spacing, points_->patch(), points_->in_space());
    make_rest();
    if (result_.unrolled) begin_unrolled(first);
    if (dic.table) begin_table(*dic.table);
    require_pulled_clip();
    forces_ = frame_forces(dic, result_.session.clips);
    result_.cameras = points_->cameras();
    begin_middle();
    for (const DicClip& clip : dic.clips) {
      if (clip.motion != ClipMotion::points) result_.slips.push_back({clip.name, {}});
    }
  }

  DicSession followed() && {
    ProgressTask task(context_.progress, "frames", dic_.frame_count());
    for (int f = 0; f < dic_.frame_count(); ++f) {
      context_.stop.throw_if_requested();
      follow(f);
      task.advance(f + 1);
    }
    if (forces_->needs_clock()) result_.notes.push_back(forces_->find_clock(ways_));
    result_.force = forces_->log().force;
    result_.time = forces_->log().time;
    result_.stands = forces_->log().stands;
    result_.session.noise.force = forces_->noise();
    result_.session.balance_bound = forces_->balance_bound();
    for (auto& [f, frame] : followed_) take(f, std::move(frame));
    std::ranges::sort(result_.left_out, {}, &LeftOutFrame::frame);
    require_frames();
    std::ranges::move(points_->notes(), std::back_inserter(result_.notes));
    result_.warnings = points_->warnings();
    std::ranges::move(forces_->warnings(ways_), std::back_inserter(result_.warnings));
    result_.misses = points_->misses();
    result_.point_noise = vertices_->point_noise();
    result_.session.noise.position = vertices_->noise();
    return std::move(result_);
  }

 private:
  PointFrame read(int f) {
    PointFrame points = points_->read(f);
    if (!points.left_out.empty() || points.count() >= kFewestPoints) return points;
    throw InputError({dic_.file_of(f)},
                     fmt::format("frame {} has {} points that were seen", f, points.count()),
                     fmt::format("at least {}", kFewestPoints));
  }

  void make_rest() {
    Session& session = result_.session;
    session.test = dic_.test;
    session.info = dic_.info;
    session.sample = dic_.sample;
    session.gravity = dic_.gravity ? *dic_.gravity : gravity_by_cameras();
    const double edge = dic_.mesh.value_or(kEdge * result_.spacing);
    const std::vector<double> lines_u = lines_along(0, edge), lines_v = lines_along(1, edge);
    if (lines_u.size() > kMostVertices / lines_v.size()) {
      throw InputError({dic_.file, 0, "mesh"},
                       fmt::format("gives {} x {} vertices", lines_u.size(), lines_v.size()),
                       fmt::format("a coarser mesh, of at most {}", kMostVertices));
    }
    session.rest = grid_of_lines(lines_u, lines_v);
    for (const DicClip& clip : dic_.clips) held_.push_back(held_place(dic_, clip, session.rest));
    session.clips = session_clips(dic_.clips, held_);
  }

  /// Of the mesh, some of them at the edges of clips.
  std::vector<double> lines_along(int axis, double edge) const {
    std::vector<double> stops;
    for (const DicClip& clip : dic_.clips) {
      const Eigen::AlignedBox2d cloth = held_cloth(dic_, clip);
      stops.push_back(cloth.min()(axis));
      stops.push_back(cloth.max()(axis));
    }
    std::ranges::sort(stops);
    return lines_on_stops(0, axis == 0 ? dic_.sample.width : dic_.sample.height, stops, edge);
  }

  // In the sample's axes; none where nothing tells it.
  Eigen::Vector3d gravity_by_cameras() const {
    const auto seen = points_->gravity();
    return seen ? Eigen::Vector3d(axes_.axes * *seen) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }

  void require_pulled_clip() const {
    if (!dic_.forces || !dic_.forces->is_tester()) return;
    if (dic_.pulled_clip() != dic_.clips.end()) return;
    throw InputError(dic_.forces->where_clip, quoted_value(dic_.forces->clip) + " is no clip",
                     "the name of a clip");
  }

  /// Two clips at opposite sides pull along weft or along warp.
  void begin_middle() {
    if (dic_.clips.size() != 2 || (held_[0].outward + held_[1].outward).norm() > 0.5) return;
    const int pull = std::abs(held_[0].outward.y()) > 0.5 ? 1 : 0;
    result_.middle.emplace(pull, Eigen::Vector2d(dic_.sample.width, dic_.sample.height));
  }

  void follow(int f) {
    const PointFrame points = read(f);
    if (!points.left_out.empty()) return leave_out(f, points.left_out);
    if (lacks_extension(f)) return leave_out(f, kBeyondLog);
    const Eigen::Matrix2Xd all = places_->of(points.rest);
    const std::vector<int> free = outside_of_clips(all);
    const Eigen::Matrix2Xd rest = all(Eigen::all, free);
    Eigen::Matrix3Xd moved = axes_.of(points.moved)(Eigen::all, free);
    const Session& session = result_.session;
    SessionFrame frame;
    if (dic_.table) {
      const auto pushed = pushed_over_edge(rest, moved);
      if (!pushed) return leave_out(f, "shows hardly a point that lies on the table");
      frame.table_edge = edge_ = pushed->edge;
      pushed_ = pushed->motion;
      moved = pushed_.inverse() * moved;
    }
    SeenVertices seen = vertices_->of(session.rest, rest, moved, points.patches(free), f == 0);
    if (points.deviations.cols() > 0) {
      frame.deviations = vertex_deviations(session.rest, rest, points.deviations(Eigen::all, free),
                                           seen.leverages, kFar * result_.spacing);
    }
    frame.positions = std::move(seen.positions);
    const LocalMotion around(rest, moved, kFar * result_.spacing);
    std::size_t slip = 0;
    for (std::size_t c = 0; c < session.clips.size(); ++c) {
      frame.poses.push_back(pose_of(c, f, points, around, slip));
      for (const int vertex : session.clips[c].clamped) {
        frame.positions.col(vertex) = frame.poses[c].apply(session.rest.positions.col(vertex));
      }
    }
    if (!points.cords.empty()) see_cords(f, points.cords);
    ways_.push_back(way_of_pulled(frame));
    if (result_.middle) add_middle(rest, moved, f);
    result_.nearer.push_back(points.nearer);
    result_.qualities.push_back(points.quality);
    result_.lost.push_back(points.lost);
    note_unseen(frame);
    if (is_shown(f)) show(f, frame.positions);
    followed_.emplace_back(f, std::move(frame));
  }

  void see_cords(int f, const std::vector<std::optional<CordLine>>& lines) {
    std::vector<std::optional<CordLine>> on_sample;
    for (const auto& line : lines) {
      on_sample.push_back(line ? std::optional(axes_.of(*line)) : std::nullopt);
    }
    forces_->see_cords(f, std::move(on_sample));
  }

  /// Into the session, with its forces.
  void take(int f, SessionFrame frame) {
    std::string why = forces_->add_to(frame, f, held_);
    if (why.empty()) why = contradiction_of(result_.qualities[static_cast<std::size_t>(f)]);
    if (!why.empty()) {
      result_.left_out.push_back({f, why});
    } else if (is_slack(f) || lies_somewhere(f)) {
      result_.slack.push_back(f);
    } else {
      result_.used.push_back(f);
      result_.session.frames.push_back(std::move(frame));
    }
  }

  /// Whether a clip moves by a log that was not running.
  bool lacks_extension(int f) const {
    const std::vector<double>& extension = forces_->log().extension;
    return dic_.moves_by_log() && !extension.empty() &&
           std::isnan(extension[static_cast<std::size_t>(f)]);
  }

  /// Of the clip that the log is of, outwards, against the other (m).
  double way_of_pulled(const SessionFrame& frame) const {
    if (!forces_->needs_way()) return std::numeric_limits<double>::quiet_NaN();
    const std::size_t pulled = dic_.clip_number(dic_.forces->clip);
    double way = 0;
    for (std::size_t c = 0; c < held_.size(); ++c) {
      const Eigen::Vector3d middle =
          result_.session.rest.positions(Eigen::all, held_[c].edge).rowwise().mean();
      const double out = held_[pulled].outward.dot(frame.poses[c].apply(middle) - middle);
      way += c == pulled ? out : -out;
    }
    return way;
  }

  /// At rest, under the largest force or half way, and at the end.
  bool is_shown(int f) const {
    const std::vector<double>& force = forces_->log().force;
    const auto peak = force.empty() ? dic_.frame_count() / 2 : largest_force() - force.begin();
    return f == 0 || f == peak || f == dic_.frame_count() - 1;
  }

  /// Among the frames that the log covers.
  std::vector<double>::const_iterator largest_force() const {
    return std::ranges::max_element(forces_->log().force, {}, [](double force) {
      return std::isnan(force) ? -std::numeric_limits<double>::infinity() : force;
    });
  }

  void show(int f, const Eigen::Matrix3Xd& positions) {
    const Eigen::Matrix3Xd points =
        (axes_.axes.transpose() * (pushed_ * positions)).colwise() + axes_.corner;
    std::vector<PointsInPicture> pictures = points_->in_pictures(points);
    for (std::size_t c = 0; c < pictures.size(); ++c) {
      result_.views.push_back({f, result_.cameras[c], std::move(pictures[c])});
    }
  }

  /// What is seen where a clip is, is the clip.
  std::vector<int> outside_of_clips(const Eigen::Matrix2Xd& rest) const {
    std::vector<int> free;
    for (Eigen::Index i = 0; i < rest.cols(); ++i) {
      const bool is_hidden = std::ranges::any_of(held_, [&](const HeldPlace& held) {
        return held.cloth.volume() > 0 && held.cloth.contains(Eigen::Vector2d(rest.col(i)));
      });
      if (!is_hidden) free.push_back(static_cast<int>(i));
    }
    return free;
  }

  void leave_out(int f, const std::string& why) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    result_.left_out.push_back({f, why});
    result_.lost.push_back(0);
    result_.unseen.push_back(0);
    result_.nearer.push_back(kNone);
    result_.qualities.emplace_back();
    ways_.push_back(kNone);
    for (ClipSlip& slip : result_.slips) slip.slip.push_back(kNone);
    if (result_.middle) result_.middle->add_nothing();
  }

  void require_frames() const {
    if (!result_.session.frames.empty()) return;
    const std::string why = result_.left_out.empty()
                                ? std::string("nothing pulls in any frame")
                                : fmt::format("frame {} {}", result_.left_out.front().frame,
                                              result_.left_out.front().why);
    throw InputError({dic_.file}, "no frame can be used: " + why,
                     "frames in which the sample is seen while forces are known");
  }

  /// Whether the first frame shows the sample where it lies on something: nothing pulls it there.
  bool lies_somewhere(int f) const { return f == 0 && (dic_.table || forces_->is_free(f)); }

  /// Whether a sample that lies in a plane carries nothing after it was pulled: it has buckled out
  /// of the plane, which a single camera does not see.
  bool is_slack(int f) const {
    // Of the largest force; and of the sample's weight, which still bends it noticeably then.
    constexpr double kNothing = 0.005, kWeights = 4;
    const std::vector<double>& force = forces_->log().force;
    if (f == 0 || points_->in_space() || !result_.middle || force.empty()) return false;
    const double peak = *largest_force();
    const double weight =
        area_density(result_.session) * rest_area(result_.session.rest) * kStandardGravity;
    return force[static_cast<std::size_t>(f)] < std::max(kNothing * peak, kWeights * weight);
  }

  Pose pose_of(std::size_t c, int f, const PointFrame& points, const LocalMotion& around,
               std::size_t& slip) {
    const DicClip& clip = dic_.clips[c];
    const HeldPlace& side = held_[c];
    const Eigen::Matrix3Xd rest = result_.session.rest.positions(Eigen::all, side.edge);
    const auto by_points = pose_of_points(around, rest, side.outward, kFar * result_.spacing);
    if (clip.motion == ClipMotion::points) {
      if (by_points) return *by_points;
      throw InputError(
          {dic_.file_of(f)},
          fmt::format("frame {}: no points within {} of the clip {}", f,
                      format_quantity(kFar * result_.spacing, Dimension::length, 3), clip.name),
          "points beside it; or `motion: held` or `extension`, where it is known");
    }
    Pose pose;
    if (clip.motion == ClipMotion::labels) pose = axes_.of(*points.clips[c]);
    if (clip.motion == ClipMotion::extension) {
      const std::vector<double>& extension = forces_->log().extension;
      if (extension.empty()) {
        throw InputError(dic_.forces->data.where, "has no column of the extension",
                         fmt::format("one: the clip {} moves by it", clip.name));
      }
      const auto first = std::ranges::find_if(extension, [](double e) { return !std::isnan(e); });
      const double way = extension[static_cast<std::size_t>(f)] - *first;
      pose.translation = way * side.outward;
    }
    if (result_.unrolled) pose = one_after_another(first_poses_[c], pose);
    const Eigen::Vector3d middle = rest.rowwise().mean();
    const double out = by_points ? side.outward.dot(pose.apply(middle) - by_points->apply(middle))
                                 : std::numeric_limits<double>::quiet_NaN();
    result_.slips[slip++].slip.push_back(out);
    return pose;
  }

  /// Where clips are in the first frame, against where they are on the sample laid flat.
  void begin_unrolled(const PointFrame& first) {
    const LocalMotion around(places_->of(first.rest), axes_.of(first.moved),
                             kFar * result_.spacing);
    for (const HeldPlace& side : held_) {
      const Eigen::Matrix3Xd rest = result_.session.rest.positions(Eigen::all, side.edge);
      const auto pose = pose_of_points(around, rest, side.outward, kFar * result_.spacing);
      if (!pose) {
        throw InputError({dic_.file_of(0)},
                         fmt::format("the sample does not lie flat, and no points beside the clip "
                                     "{} tell where it is",
                                     dic_.clips[first_poses_.size()].name),
                         "points beside each clip, or a sample that lies flat at first");
      }
      first_poses_.push_back(*pose);
    }
  }

  /// Such a sheet hangs, and its frames are in its own axes.
  void begin_table(const DicTable& table) {
    result_.session.table = table.axis;
    edge_ = table.edge;
    if (!points_->in_space()) {
      throw InputError({dic_.file, 0, "table"}, "is seen in points without `z`, and cloth hangs",
                       "points in space");
    }
    if (result_.session.gravity.isZero()) {
      throw InputError({dic_.file, 0, "gravity"}, "is not known, by which the sample hangs",
                       "`gravity` here, or in the calibration of the cameras (a levelled board)");
    }
  }

  std::optional<PushedSheet> pushed_over_edge(const Eigen::Matrix2Xd& rest,
                                              const Eigen::Matrix3Xd& moved) const {
    Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, rest.cols());
    flat.topRows<2>() = rest;
    const Eigen::Vector2d size(dic_.sample.width, dic_.sample.height);
    const double middle = size(1 - static_cast<Eigen::Index>(dic_.table->axis)) / 2;
    return pushed_sheet(flat, moved, *dic_.table, middle, edge_, 2 * result_.spacing);
  }

  void add_middle(const Eigen::Matrix2Xd& rest, const Eigen::Matrix3Xd& moved, int f) {
    if (result_.middle->add(rest, moved)) return;
    throw InputError({dic_.file_of(f)},
                     fmt::format("frame {}: no points in the middle of the sample", f),
                     "at least five that do not lie in a line");
  }

  void note_unseen(const SessionFrame& frame) {
    int unseen = 0;
    for (const auto& position : frame.positions.colwise()) unseen += !position.allFinite();
    result_.unseen.push_back(unseen);
  }

  const DicFile& dic_;
  RunContext context_;
  std::unique_ptr<PointSource> points_;
  SampleAxes axes_;
  std::optional<RestPlaces> places_;
  std::optional<VertexPlaces> vertices_;
  std::unique_ptr<FrameForces> forces_;
  std::vector<std::pair<int, SessionFrame>> followed_;  // without forces yet
  std::vector<double> ways_;  // of each frame, of the clip whose log has no clock yet
  DicSession result_;
  std::vector<HeldPlace> held_;                               // of each clip
  std::vector<Pose> first_poses_;                             // likewise, of unrolled sheets
  double edge_ = 0;                                           // of the table in the frame before
  Eigen::Isometry3d pushed_ = Eigen::Isometry3d::Identity();  // of a sheet on a table
};

}  // namespace

DicSession make_dic_session(const DicFile& dic, const ReadPicture& read_picture,
                            const RunContext& context) {
  return SheetFollower(dic, read_picture, context).followed();
}

}  // namespace pliant
