#include "pliant/measurement/session/clip_poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "pliant/io/csv_writer.h"
#include "pliant/measurement/session/frame_axes.h"

namespace pliant {
namespace {

// A quaternion that is of unit length but for the last bits is kept as it is.
constexpr double kLastBits = 1e-14;

Eigen::Quaterniond unit_quaternion(const Eigen::Quaterniond& read, int frame,
                                   const std::string& clip, const Location& where) {
  const double length = read.norm();
  if (std::abs(length - 1) > kQuaternionRounding) {
    throw InputError(
        where,
        fmt::format("frame {}, clip {}: the quaternion has the length {:.4g}", frame, clip, length),
        fmt::format("unit length within {}, in the order qw, qx, qy, qz", kQuaternionRounding));
  }
  return std::abs(length - 1) > kLastBits ? read.normalized() : read;
}

/// Every clip in every frame, once.
void require_all(const ClipPoses& poses, const std::vector<SessionClip>& clips) {
  for (std::size_t clip = 0; clip < clips.size(); ++clip) {
    const auto lacks = [&](const std::vector<int>& lines) { return lines[clip] == 0; };
    const auto missing = std::find_if(poses.lines.begin(), poses.lines.end(), lacks);
    if (missing == poses.lines.end()) continue;
    const bool never = std::all_of(poses.lines.begin(), poses.lines.end(), lacks);
    const auto frame = missing - poses.lines.begin();
    throw InputError({poses.file, 0, "clip"},
                     never
                         ? fmt::format("clip {} is never tracked", clips[clip].name)
                         : fmt::format("clip {} has no pose in frame {}", clips[clip].name, frame),
                     "a row for each clip in each frame");
  }
}

/// The vertex of a clip, of those that were seen, that is farthest from where a pose puts it.
struct Drift {
  int vertex = 0;
  double distance = 0;  // m
};

Drift largest_drift(const SessionClip& clip, const TriangleMesh& rest,
                    const Eigen::Matrix3Xd& positions, const Pose& pose) {
  Drift largest;
  for (const int vertex : clip.clamped) {
    const double distance = (pose.apply(rest.positions.col(vertex)) - positions.col(vertex)).norm();
    if (distance >= largest.distance) largest = {vertex, distance};  // not of NaN, where unseen
  }
  return largest;
}

/// The pose in axes of which one points the other way: S R S, S t with S the reflection.
Pose mirrored(const Pose& pose, int axis) {
  Pose result = pose;
  result.translation[axis] = -result.translation[axis];
  for (int other = 0; other < 3; ++other) {
    if (other != axis) result.rotation.coeffs()[other] = -result.rotation.coeffs()[other];
  }
  return result;
}

Pose inverse(const Pose& pose) {
  const Eigen::Quaterniond back = pose.rotation.conjugate();
  return {back, -(back * pose.translation)};
}

/// Whether a clip has the same pose in all of several frames.
bool stands_still(const Session& session, std::size_t clip) {
  const Pose& first = session.frames.front().poses[clip];
  return session.frame_count() > 1 &&
         std::ranges::all_of(session.frames, [&](const SessionFrame& frame) {
           return frame.poses[clip].translation == first.translation &&
                  frame.poses[clip].rotation.coeffs() == first.rotation.coeffs();
         });
}

/// What would explain a pose that does not fit.
std::string explanation(const Session& session, std::size_t clip_number, std::size_t frame,
                        double most) {
  const SessionClip& clip = session.clips[clip_number];
  const TriangleMesh& rest = session.rest;
  const Eigen::Matrix3Xd& positions = session.frames[frame].positions;
  const Pose& pose = session.frames[frame].poses[clip_number];
  const auto fits = [&](const Pose& other) {
    return largest_drift(clip, rest, positions, other).distance <= most;
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (fits(mirrored(pose, axis))) {
      return fmt::format(" (the pose would fit with the {} axis mirrored)", "xyz"[axis]);
    }
  }
  if (fits(inverse(pose))) return " (the inverse of the pose would fit)";
  if (stands_still(session, clip_number)) {
    return " (its pose is the same in all frames: was it tracked?)";
  }
  Eigen::Matrix3Xd expected = rest.positions(Eigen::all, clip.clamped);
  for (auto place : expected.colwise()) place = pose.apply(place);
  return explaining_axes(positions(Eigen::all, clip.clamped), expected, most);
}

}  // namespace

ClipPoses read_clip_poses(const FrameRows& rows, const std::vector<SessionClip>& clips, int frames,
                          FrameTimes& times) {
  const CsvTable& table = rows.table();
  const std::vector<int> clip_of = rows.clips(clips);
  std::array<std::vector<double>, 7> columns;
  constexpr std::array kNames{"tx", "ty", "tz", "qw", "qx", "qy", "qz"};
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = table.numbers(kNames[i]);

  ClipPoses result;
  result.file = table.file();
  result.poses.assign(static_cast<std::size_t>(frames), std::vector<Pose>(clips.size()));
  result.lines.assign(static_cast<std::size_t>(frames), std::vector<int>(clips.size()));
  for (int row = 0; row < rows.rows(); ++row) {
    const auto r = static_cast<std::size_t>(row);
    const auto frame = static_cast<std::size_t>(rows.frame(row));
    const auto clip = static_cast<std::size_t>(clip_of[r]);
    int& line = result.lines[frame][clip];
    if (line != 0) {
      throw InputError(rows.location(row, "clip"),
                       fmt::format("clip {} has a pose in frame {} already, on line {}",
                                   clips[clip].name, frame, line),
                       "one row for each clip in each frame");
    }
    line = rows.location(row, "clip").line;
    const Eigen::Quaterniond read(columns[3][r], columns[4][r], columns[5][r], columns[6][r]);
    result.poses[frame][clip] = {
        unit_quaternion(read, rows.frame(row), clips[clip].name, rows.location(row, "qw")),
        {columns[0][r], columns[1][r], columns[2][r]}};
  }
  require_all(result, clips);
  times.take(rows);
  return result;
}

void require_clamped_vertices(const Session& session, const ClipPoses& poses) {
  const double side = std::max(session.sample.width, session.sample.height);
  const double most = kClampDrift * side;
  for (std::size_t f = 0; f < session.frames.size(); ++f) {
    const SessionFrame& frame = session.frames[f];
    for (std::size_t c = 0; c < session.clips.size(); ++c) {
      const SessionClip& clip = session.clips[c];
      const Drift drift = largest_drift(clip, session.rest, frame.positions, frame.poses[c]);
      if (drift.distance <= most) continue;
      throw InputError(
          {poses.file, poses.lines[f][c], "clip"},
          fmt::format("frame {}, clip {}: vertex {} is {} from where the pose puts it{}", f,
                      clip.name, drift.vertex, format_quantity(drift.distance, Dimension::length),
                      explanation(session, c, f, most)),
          fmt::format("at most {} ({:.0f} % of the sample): x = R(q) x_rest + t about the world "
                      "origin, tx, ty, tz in metres",
                      format_quantity(most, Dimension::length), 100 * kClampDrift));
    }
  }
}

std::string clip_pose_table(const Session& session) {
  const bool timed =
      all_rows_timed(session, [](const SessionFrame& frame) { return !frame.poses.empty(); });
  std::vector<std::string> header{"frame", "clip", "tx", "ty", "tz", "qw", "qx", "qy", "qz"};
  if (timed) header.emplace_back("time_s");
  CsvWriter writer(header);
  for (int f = 0; f < session.frame_count(); ++f) {
    const SessionFrame& frame = session.frames[static_cast<std::size_t>(f)];
    for (std::size_t c = 0; c < session.clips.size(); ++c) {
      const Pose& pose = frame.poses[c];
      writer.cell(f).cell(session.clips[c].name);
      for (const double number : pose.translation) writer.cell(number);
      writer.cell(pose.rotation.w());
      for (const double number : pose.rotation.vec()) writer.cell(number);
      if (timed) writer.cell(*frame.time);
      writer.end_row();
    }
  }
  return writer.text();
}

}  // namespace pliant
