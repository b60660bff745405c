#include "pliant/measurement/session/cord_checks.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/measurement/session/balance.h"

namespace pliant {
namespace {

constexpr int kDigits = 3;

const SessionFrame& frame_of(const Session& session, int frame) {
  return session.frames[static_cast<std::size_t>(frame)];
}

double distance_from_clip(const Session& session, int frame, std::size_t clip,
                          const Eigen::Vector3d& point) {
  const Eigen::Matrix3Xd at =
      frame_of(session, frame).positions(Eigen::all, session.clips[clip].clamped);
  return (at.colwise() - point).colwise().norm().minCoeff();
}

/// A cord of a clip that is attached nearer to another one, as where clips are confused.
void warn_of_other_clips(const Session& session, std::size_t clip,
                         std::vector<std::string>& warnings) {
  for (int f = 0; f < session.frame_count(); ++f) {
    for (const CordForce& cord : frame_of(session, f).cords[clip]) {
      const double own = distance_from_clip(session, f, clip, cord.point);
      for (std::size_t other = 0; other < session.clips.size(); ++other) {
        const double distance = distance_from_clip(session, f, other, cord.point);
        if (distance >= own) continue;
        warnings.push_back(fmt::format(
            "frame {}, clip {}: a cord is attached {} from this clip and {} from clip {} "
            "(expected: next to its own clip)",
            f, session.clips[clip].name, format_quantity(own, Dimension::length),
            format_quantity(distance, Dimension::length), session.clips[other].name));
        return;
      }
    }
  }
}

/// The place of a cord on its clip at rest; none where it is not measured.
std::optional<Eigen::Vector3d> place_of(const Session& session, int frame, std::size_t clip,
                                        std::size_t cord) {
  const SessionFrame& now = frame_of(session, frame);
  if (cord >= now.cords[clip].size()) return std::nullopt;
  const Pose& pose = now.poses[clip];
  return pose.rotation.conjugate() * (now.cords[clip][cord].point - pose.translation);
}

double middle_of(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::ranges::nth_element(numbers, middle);
  return *middle;
}

/// The frame in which a cord is farthest from where it usually is: its place is that of the middle
/// frame, coordinate by coordinate, which single slips do not move.
void warn_of_drift(const Session& session, std::size_t clip, std::size_t cord,
                   std::vector<std::string>& warnings) {
  std::array<std::vector<double>, 3> coordinates;
  for (int f = 0; f < session.frame_count(); ++f) {
    const auto place = place_of(session, f, clip, cord);
    for (int axis = 0; place && axis < 3; ++axis) {
      coordinates[static_cast<std::size_t>(axis)].push_back((*place)[axis]);
    }
  }
  if (coordinates[0].empty()) return;
  const Eigen::Vector3d usual(middle_of(coordinates[0]), middle_of(coordinates[1]),
                              middle_of(coordinates[2]));
  const double most = kCordDrift * std::max(session.sample.width, session.sample.height);
  double largest = most;
  int worst = -1;
  for (int f = 0; f < session.frame_count(); ++f) {
    const auto place = place_of(session, f, clip, cord);
    if (!place || (*place - usual).norm() <= largest) continue;
    largest = (*place - usual).norm();
    worst = f;
  }
  if (worst < 0) return;
  const std::string& name = frame_of(session, worst).cords[clip][cord].cord;
  warnings.push_back(fmt::format(
      "frame {}, clip {}: cord {} is attached {} from its place on the clip in other "
      "frames (expected: at most {})",
      worst, session.clips[clip].name, name.empty() ? std::to_string(cord + 1) : name,
      format_quantity(largest, Dimension::length), format_quantity(most, Dimension::length)));
}

void warn_of_gaps(const Session& session, std::size_t clip, std::vector<std::string>& warnings) {
  std::size_t most = 0;
  for (const SessionFrame& frame : session.frames) most = std::max(most, frame.cords[clip].size());
  int missing = 0, first = 0;
  for (int f = session.frame_count(); f-- > 0;) {
    if (frame_of(session, f).cords[clip].size() == most) continue;
    ++missing;
    first = f;
  }
  if (missing == 0) return;
  warnings.push_back(
      fmt::format("clip {} has fewer than its {} cords in {} of {} frames, first in frame {}: what "
                  "pulls at it is not known there",
                  session.clips[clip].name, most, missing, session.frame_count(), first));
}

void warn_of_no_forces(const Session& session, std::vector<std::string>& warnings) {
  const bool any = std::ranges::any_of(session.frames, [](const SessionFrame& frame) {
    return std::ranges::any_of(frame.cords, [](const auto& cords) { return !cords.empty(); });
  });
  if (any || session.clips.empty()) return;
  warnings.emplace_back(
      "no cord pulls at any clip: positions can be compared, forces cannot (expected: rows in "
      "cords.csv)");
}

/// What pulls clips together in a frame, which a sheet cannot resist (N); negative: apart.
double push(const Session& session, int frame) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  const int clips = static_cast<int>(session.clips.size());
  for (int clip = 0; clip < clips; ++clip) middle += clip_middle(session, frame, clip) / clips;
  double sum = 0;
  for (int clip = 0; clip < clips; ++clip) {
    const Eigen::Vector3d outward = (clip_middle(session, frame, clip) - middle).normalized();
    sum -= outward.dot(clip_load(session, frame, clip, middle).force);
  }
  return sum;
}

void warn_of_pushing(const Session& session, std::vector<std::string>& warnings) {
  if (session.clips.size() < 2 || session.table) return;
  int count = 0, worst = 0;
  double largest = 0;
  for (int f = 0; f < session.frame_count(); ++f) {
    std::size_t cords = 0;
    for (const auto& of_clip : frame_of(session, f).cords) cords += of_clip.size();
    const double now = push(session, f);
    if (cords == 0 || now <= session.balance_bound * static_cast<double>(cords)) continue;
    ++count;
    if (now <= largest) continue;
    largest = now;
    worst = f;
  }
  if (count == 0) return;
  warnings.push_back(fmt::format(
      "cords push the clips together in {} of {} frames, most in frame {}: by {} N (expected: "
      "forces on the clips, which pull them apart, in the axes of the frames)",
      count, session.frame_count(), worst, format_number(largest, kDigits)));
}

}  // namespace

std::vector<std::string> cord_warnings(const Session& session) {
  std::vector<std::string> warnings;
  warn_of_no_forces(session, warnings);
  for (std::size_t clip = 0; clip < session.clips.size(); ++clip) {
    warn_of_other_clips(session, clip, warnings);
    warn_of_gaps(session, clip, warnings);
    std::size_t most = 0;
    for (const SessionFrame& frame : session.frames) {
      most = std::max(most, frame.cords[clip].size());
    }
    for (std::size_t cord = 0; cord < most; ++cord) warn_of_drift(session, clip, cord, warnings);
  }
  warn_of_pushing(session, warnings);
  return warnings;
}

}  // namespace pliant
