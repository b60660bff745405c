#include "pliant/experiment/session/virtual/observed_session.h"

#include <vector>

#include <Eigen/Geometry>

#include "pliant/experiment/session/cord_drag.h"

namespace pliant {
namespace {

Eigen::Vector3d at_rest(const Pose& pose, const Eigen::Vector3d& point) {
  return pose.rotation.conjugate() * (point - pose.translation);
}

void add_to_pull(CordForce& cord, double more) {
  if (cord.force.norm() > 0) cord.force += more * cord.force.normalized();
}

/// Adds what the load cells show of the drags of all cords, which are in the same order in all
/// frames.
void add_cord_friction(double width, Session& session) {
  std::vector<std::size_t> count(session.clips.size(), 0);
  for (const CordDrag& drag : cord_drags(session)) {
    const auto clip = static_cast<std::size_t>(drag.clip);
    const std::size_t place = count[clip]++;
    for (std::size_t f = 0; f < session.frames.size(); ++f) {
      Eigen::Vector3d& force = session.frames[f].cords[clip][place].force;
      if (force.norm() > 0) force += width * drag.forces.col(static_cast<Eigen::Index>(f));
    }
  }
}

Eigen::Vector3d white_noise(double deviation, RandomStream& random) {
  const double x = random.normal(), y = random.normal(), z = random.normal();
  return deviation * Eigen::Vector3d(x, y, z);
}

/// The rigid motion that takes points to where they were seen, best in the mean of squares.
Pose fitted_pose(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& seen) {
  const Eigen::Matrix4d motion = Eigen::umeyama(points, seen, /*with_scaling=*/false);
  const Eigen::Matrix3d rotation = motion.topLeftCorner<3, 3>();
  return {Eigen::Quaterniond(rotation).normalized(), motion.topRightCorner<3, 1>()};
}

void add_position_noise(double deviation, const Session& session, RandomStream& random,
                        SessionFrame& frame) {
  for (auto position : frame.positions.colwise()) position += white_noise(deviation, random);
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    const std::vector<int>& clamped = session.clips[c].clamped;
    const auto vertices = static_cast<Eigen::Index>(clamped.size());
    const auto cords = static_cast<Eigen::Index>(frame.cords[c].size());
    Eigen::Matrix3Xd points(3, vertices + cords), seen(3, vertices + cords);
    points.leftCols(vertices) = session.rest.positions(Eigen::all, clamped);
    seen.leftCols(vertices) = frame.positions(Eigen::all, clamped);
    for (Eigen::Index i = 0; i < cords; ++i) {
      CordForce& cord = frame.cords[c][static_cast<std::size_t>(i)];
      points.col(vertices + i) = at_rest(frame.poses[c], cord.point);
      cord.point += white_noise(deviation, random);
      seen.col(vertices + i) = cord.point;
    }
    frame.poses[c] = fitted_pose(points, seen);
  }
}

}  // namespace

void observe(const SessionNoise& noise, RandomStream& random, Session& session) {
  if (noise.cord_friction > 0) add_cord_friction(noise.cord_friction, session);
  for (SessionFrame& frame : session.frames) {
    if (noise.force > 0) {
      for (std::vector<CordForce>& cords : frame.cords) {
        for (CordForce& cord : cords) add_to_pull(cord, noise.force * random.normal());
      }
    }
    if (noise.position > 0) add_position_noise(noise.position, session, random, frame);
  }
}

}  // namespace pliant
