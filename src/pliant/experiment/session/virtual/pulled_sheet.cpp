#include "pliant/experiment/session/virtual/pulled_sheet.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/experiment/session/virtual/cord_pulls.h"
#include "pliant/experiment/session/virtual/test_clips.h"
#include "pliant/solver/static_path.h"

namespace pliant {
namespace {

constexpr double kRounding = 1e-9;  // of a clip's edges (m)

Eigen::Vector3d in_space(const Eigen::Vector2d& point) { return {point.x(), point.y(), 0}; }

SessionClip session_clip(const TestClip& clip, const CutSheet& sheet, double mass) {
  SessionClip result{clip.name, mass, {}};
  for (int i = 0; i < sheet.rest.vertex_count(); ++i) {
    if (clip.holds.squaredExteriorDistance(sheet.places.col(i)) < kRounding * kRounding) {
      result.clamped.push_back(i);
    }
  }
  return result;
}

/// The pose relative to the rest mesh under a load.
Pose pose_under(const TestClip& clip, const Pose& placed, double load) {
  const PlaneMotion motion = clip.motion(load);
  const Eigen::Vector3d pivot = placed.apply(in_space(clip.pivot));
  const Eigen::Vector3d shift = placed.rotation * in_space(motion.shift);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(motion.turn, Eigen::Vector3d::UnitZ()));
  return {turn, pivot + shift - turn * pivot};
}

/// What holds a clip about the middle of its vertices, where its weight acts.
Wrench holding_wrench(const Session& session, int frame, int clip, const PathEquilibrium& point,
                      const Eigen::Vector3d& force) {
  const Eigen::Vector3d centre = clip_middle(session, frame, clip);
  Wrench wrench{force, Eigen::Vector3d::Zero()};
  for (const int node : session.clips[static_cast<std::size_t>(clip)].clamped) {
    const Eigen::Vector3d arm =
        session.frames[static_cast<std::size_t>(frame)].positions.col(node) - centre;
    wrench.moment += arm.cross(Eigen::Vector3d(point.forces.col(node)));
  }
  return wrench;
}

PathEquilibrium step_to(int frame, StaticPath& path, const SessionWork& work) {
  try {
    return path.step(frame + 1);
  } catch (const SolverError& error) {
    throw SolverError(fmt::format("virtual session {}: frame {}", work.name, frame),
                      error.iterations(), error.best_residual());
  }
}

std::vector<CordForce> cords_of(const TestClip& clip, const Pose& placed, const Pose& pose,
                                const Wrench& wrench, const Eigen::Vector3d& centre) {
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector2d& place : clip.cords) {
    points.push_back(pose.apply(placed.apply(in_space(place))));
  }
  const std::vector<Eigen::Vector3d> pulls = cord_pulls(wrench, centre, points);
  return {{"1", points[0], pulls[0]}, {"2", points[1], pulls[1]}};
}

/// Adds the clips of a test, and frames with their poses alone.
void add_clips(const std::vector<TestClip>& clips, const CutSheet& sheet,
               const VirtualSession& options, Session& session) {
  for (const TestClip& clip : clips) {
    session.clips.push_back(session_clip(clip, sheet, options.clip_mass));
  }
  for (const double load : frame_loads(options)) {
    SessionFrame frame;
    for (const TestClip& clip : clips) frame.poses.push_back(pose_under(clip, sheet.placed, load));
    session.frames.push_back(std::move(frame));
  }
}

}  // namespace

void pull_sheet(const CutSheet& sheet, const Material& material, const VirtualSession& options,
                const SessionWork& work, Session& session) {
  const std::vector<TestClip> clips = test_clips(options);
  add_clips(clips, sheet, options, session);
  const SheetSystem held(session, material, {}, held_nodes(session, std::nullopt));
  session.warnings.insert(session.warnings.end(), held.warnings().begin(), held.warnings().end());
  StaticPath path(
      held.system(),
      {.newton = {.tolerance = held.tolerance(), .reuse_factor = true, .stop = work.stop},
       .schedule = held.schedule()});
  for (int f = 0; f < session.frame_count(); ++f) {
    const PathEquilibrium point = step_to(f, path, work);
    SessionFrame& frame = session.frames[static_cast<std::size_t>(f)];
    frame.positions = path.state().configuration.positions;
    const Eigen::Matrix3Xd forces = held.clip_forces(point.forces);
    for (std::size_t c = 0; c < clips.size(); ++c) {
      const int clip = static_cast<int>(c);
      const Wrench wrench = holding_wrench(session, f, clip, point, forces.col(clip));
      frame.cords.push_back(
          cords_of(clips[c], sheet.placed, frame.poses[c], wrench, clip_middle(session, f, clip)));
    }
    work.done(1);
  }
}

}  // namespace pliant
