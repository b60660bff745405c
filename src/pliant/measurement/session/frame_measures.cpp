#include "pliant/measurement/session/frame_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "pliant/measurement/session/balance.h"

namespace pliant {
namespace {

using Gradient = Eigen::Matrix<double, 3, 2>;

/// Points on one line, but for rounding: squared extent across it over that along it.
constexpr double kOnLine = 1e-9;

/// Where the first clip around the rest mesh may stand, as an angle from the weft axis: a little
/// before it, so that noise in a clip's place does not turn the signs. Corners are at 45 degrees.
constexpr double kFirstAngle = -std::numbers::pi / 16;

Eigen::Matrix3Xd centred(const Eigen::Matrix3Xd& points) {
  return points.colwise() - points.rowwise().mean();
}

/// (w_u, w_v) of the affine map from the rest plane that fits vertices in least squares.
std::optional<Gradient> best_fit(const Eigen::Matrix3Xd& rest, const Eigen::Matrix3Xd& positions) {
  const Eigen::Matrix2Xd plane = centred(rest).topRows<2>();
  const Eigen::Matrix2d spread = plane * plane.transpose();
  const Eigen::Vector2d extents =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread, Eigen::EigenvaluesOnly).eigenvalues();
  if (extents[0] <= kOnLine * extents[1]) return std::nullopt;
  return centred(positions) * plane.transpose() * spread.inverse();
}

std::vector<int> clamped_vertices(const Session& session) {
  std::vector<int> vertices;
  for (const SessionClip& clip : session.clips) {
    vertices.insert(vertices.end(), clip.clamped.begin(), clip.clamped.end());
  }
  return vertices;
}

/// The middle of a clip's clamped vertices at rest, from the middle of the rest mesh (m).
Eigen::Vector2d rest_place(const Session& session, const SessionClip& clip) {
  const Eigen::Matrix2Xd vertices = session.rest.positions.topRows<2>();
  const Eigen::Vector2d middle =
      (vertices.rowwise().minCoeff() + vertices.rowwise().maxCoeff()) / 2;
  return vertices(Eigen::all, clip.clamped).rowwise().mean() - middle;
}

/// The clips counter-clockwise around the rest mesh.
std::vector<int> clips_around(const Session& session) {
  const auto angle = [&](int clip) {
    const Eigen::Vector2d place =
        rest_place(session, session.clips[static_cast<std::size_t>(clip)]);
    const double from_weft = std::atan2(place.y(), place.x());
    return from_weft < kFirstAngle ? from_weft + 2 * std::numbers::pi : from_weft;
  };
  std::vector<int> order(session.clips.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, angle);
  return order;
}

/// The clips at the corners: lower left, lower right, upper left, upper right. A clip is at a
/// corner where it is more than a quarter of the sheet from its middle both ways.
std::optional<std::array<int, 4>> corner_clips(const Session& session) {
  if (session.clips.size() != 4) return std::nullopt;
  std::array<int, 4> corners{-1, -1, -1, -1};
  for (int clip = 0; clip < 4; ++clip) {
    const Eigen::Vector2d place =
        rest_place(session, session.clips[static_cast<std::size_t>(clip)]);
    const bool at_corner = std::abs(place.x()) > session.sample.width / 4 &&
                           std::abs(place.y()) > session.sample.height / 4;
    int& corner =
        corners[static_cast<std::size_t>((place.x() > 0 ? 1 : 0) + (place.y() > 0 ? 2 : 0))];
    if (!at_corner || corner >= 0) return std::nullopt;
    corner = clip;
  }
  return corners;
}

/// Mean pull of two clips away from each other (N).
double tension(const Session& session, int frame, int from, int to) {
  const auto force = [&](int clip) {
    return clip_load(session, frame, clip, Eigen::Vector3d::Zero()).force;
  };
  const Eigen::Vector3d along =
      (clip_middle(session, frame, to) - clip_middle(session, frame, from)).normalized();
  return (force(to) - force(from)).dot(along) / 2;
}

}  // namespace

Eigen::Vector3d rest_middle(const Session& session, int clip) {
  const auto& clamped = session.clips[static_cast<std::size_t>(clip)].clamped;
  return session.rest.positions(Eigen::all, clamped).rowwise().mean();
}

double travel(const Session& session, int frame) {
  const SessionFrame& now = session.frames[static_cast<std::size_t>(frame)];
  if (session.table && now.table_edge) {
    const Eigen::RowVectorXd along = session.rest.positions.row(static_cast<int>(*session.table));
    return along.maxCoeff() - *now.table_edge;
  }
  double sum = 0;
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    const Eigen::Vector3d middle = rest_middle(session, static_cast<int>(c));
    sum += (now.poses[c].apply(middle) - middle).norm();
  }
  return sum;
}

bool returns(const Session& session) {
  constexpr double kShare = 0.1;
  double most = 0, back = 0;
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    const double now = travel(session, frame);
    most = std::max(most, now);
    back = std::max(back, most - now);
  }
  return back > kShare * most;
}

std::optional<double> effective_shear(const Session& session, int frame) {
  const std::vector<int> clamped = clamped_vertices(session);
  if (clamped.empty()) return std::nullopt;
  const auto& positions = session.frames[static_cast<std::size_t>(frame)].positions;
  const auto gradient =
      best_fit(session.rest.positions(Eigen::all, clamped), positions(Eigen::all, clamped));
  if (!gradient) return std::nullopt;
  const Eigen::Vector3d weft = gradient->col(0), warp = gradient->col(1);
  return std::atan2(weft.dot(warp), weft.cross(warp).norm());
}

double aggregated_torque(const Session& session, int frame) {
  const auto& positions = session.frames[static_cast<std::size_t>(frame)].positions;
  const Gradient gradient = best_fit(session.rest.positions, positions).value();
  const Eigen::Vector3d weft = gradient.col(0), warp = gradient.col(1);
  const Eigen::Vector3d normal = weft.cross(warp).normalized();
  const Eigen::Vector3d centre = sheet_centre(session, frame);
  double torque = 0, sign = 1;
  for (const int clip : clips_around(session)) {
    torque += sign * clip_load(session, frame, clip, centre).moment.dot(normal);
    sign = -sign;
  }
  return torque;
}

std::optional<double> stretching_force_difference(const Session& session, int frame) {
  const auto corners = corner_clips(session);
  if (!corners) return std::nullopt;
  const auto [lower_left, lower_right, upper_left, upper_right] = *corners;
  return tension(session, frame, lower_left, upper_right) -
         tension(session, frame, lower_right, upper_left);
}

std::optional<double> clip_extension(const Session& session, int frame) {
  if (session.clips.size() != 2) return std::nullopt;
  const auto& cords = session.frames[static_cast<std::size_t>(frame)].cords[1];
  const bool by_tester = session.kind == SessionKind::strip && !cords.empty();
  const Eigen::Vector3d end = by_tester ? cords.front().point : clip_middle(session, frame, 1);
  const double now = (end - clip_middle(session, frame, 0)).norm();
  return now - (rest_middle(session, 1) - rest_middle(session, 0)).norm();
}

std::optional<double> clip_pull(const Session& session, int frame) {
  if (session.clips.size() != 2) return std::nullopt;
  const double mean = tension(session, frame, 0, 1);
  // The fixed clamp of a tester has no load cell.
  return session.kind == SessionKind::strip ? 2 * mean : mean;
}

}  // namespace pliant
