#include "pliant/report/force_curve.h"

#include <numbers>
#include <optional>
#include <string_view>

#include "pliant/experiment/session/sheet_test.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/measurement/session/frame_measures.h"

namespace pliant::report {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kMilli = 1e3;

struct ClipPair {
  int from = 0, to = 0;
};

/// The two clips that a test moves against each other, and nothing where all of them count.
std::optional<ClipPair> opposite_clips(const Session& session) {
  const int clips = static_cast<int>(session.clips.size());
  if (!session.test.starts_with("stretch") || clips < 2) {
    return clips == 2 ? std::optional(ClipPair{0, 1}) : std::nullopt;
  }
  const int axis = session.test == "stretch-warp" ? 1 : 0;
  ClipPair pair;
  for (int clip = 0; clip < clips; ++clip) {
    const double place = rest_middle(session, clip)(axis);
    if (place < rest_middle(session, pair.from)(axis)) pair.from = clip;
    if (place > rest_middle(session, pair.to)(axis)) pair.to = clip;
  }
  return pair;
}

/// Half the difference of the forces of two clips (N).
Eigen::Vector3d pull(const Session& session, int frame, ClipPair pair) {
  const auto force = [&](int clip) {
    return clip_load(session, frame, clip, Eigen::Vector3d::Zero()).force;
  };
  return (force(pair.to) - force(pair.from)) / 2;
}

Eigen::Vector3d apart(const Session& session, int frame, ClipPair pair) {
  return clip_middle(session, frame, pair.to) - clip_middle(session, frame, pair.from);
}

/// What a tensile tester shows.
ForceCurve tester_curve(const Session& session) {
  ForceCurve curve{"", {"Extension", "mm"}, {"Force", "N"}, {}, {}};
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    if (session.frames[static_cast<std::size_t>(frame)].cords[1].empty()) continue;
    curve.displacement.push_back(kMilli * *clip_extension(session, frame));
    curve.force.push_back(*clip_pull(session, frame));
  }
  return curve;
}

ForceCurve pull_curve(const Session& session, ClipPair pair) {
  ForceCurve curve{"", {"Extension", "mm"}, {"Mean pull", "N"}, {}, {}};
  const double at_rest = (rest_middle(session, pair.to) - rest_middle(session, pair.from)).norm();
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    const Eigen::Vector3d now = apart(session, frame, pair);
    curve.displacement.push_back(kMilli * (now.norm() - at_rest));
    curve.force.push_back(pull(session, frame, pair).dot(now.normalized()));
  }
  return curve;
}

/// Across the line between the clips at rest, in the plane of the sheet.
ForceCurve slide_curve(const Session& session, ClipPair pair) {
  ForceCurve curve{"", {"Slide of opposite clips", "mm"}, {"Mean pull", "N"}, {}, {}};
  const Eigen::Vector3d at_rest = rest_middle(session, pair.to) - rest_middle(session, pair.from);
  const Eigen::Vector3d along = at_rest.cross(Eigen::Vector3d::UnitZ()).normalized();
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    curve.displacement.push_back(kMilli * (apart(session, frame, pair) - at_rest).dot(along));
    curve.force.push_back(pull(session, frame, pair).dot(along));
  }
  return curve;
}

/// Corner pulls and shear; nothing where the clips do not span the sheet.
std::optional<ForceCurve> shear_curve(const Session& session) {
  if (!effective_shear(session, 0)) return std::nullopt;
  const bool corners = stretching_force_difference(session, 0).has_value();
  ForceCurve curve{"", {"Effective shear", "°"}, {"Aggregated torque", "mN m"}, {}, {}};
  if (corners) curve.of = {"Stretching-force difference", "N"};
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    curve.displacement.push_back(kDegrees * *effective_shear(session, frame));
    curve.force.push_back(corners ? *stretching_force_difference(session, frame)
                                  : kMilli * aggregated_torque(session, frame));
  }
  return curve;
}

ForceCurve clip_curve(const Session& session, int clip) {
  ForceCurve curve{session.clips[static_cast<std::size_t>(clip)].name,
                   {"Displacement of the clip", "mm"},
                   {"Force of the cords", "N"},
                   {},
                   {}};
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    curve.displacement.push_back(
        kMilli * (clip_middle(session, frame, clip) - rest_middle(session, clip)).norm());
    curve.force.push_back(cord_pull(session, frame, clip).norm());
  }
  return curve;
}

}  // namespace

std::vector<ForceCurve> force_curves(const Session& session) {
  if (session.frames.empty()) return {};
  if (session.kind == SessionKind::strip) return {tester_curve(session)};
  if (const auto pair = opposite_clips(session)) {
    return {session.test == "complex-shear" ? slide_curve(session, *pair)
                                            : pull_curve(session, *pair)};
  }
  if (session.clips.size() == 4) {
    if (auto curve = shear_curve(session)) return {std::move(*curve)};
  }
  std::vector<ForceCurve> curves;
  for (std::size_t clip = 0; clip < session.clips.size(); ++clip) {
    curves.push_back(clip_curve(session, static_cast<int>(clip)));
  }
  return curves;
}

}  // namespace pliant::report
