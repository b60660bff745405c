#include "pliant/scene/motion.h"

#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

// Axes count as one below this sine of the angle between them: rounding of their normalisation.
constexpr double kParallel = 1e-12;

Eigen::Quaterniond quaternion_of(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation_vector / angle));
}

bool turn_about_one_axis(const Rotation& from, const Rotation& to) {
  if (!from.counts_turns || !to.counts_turns) return false;
  return from.angle == 0 || to.angle == 0 || from.axis.cross(to.axis).norm() < kParallel;
}

}  // namespace

Eigen::Vector3d turn_between(const Rotation& from, const Rotation& to) {
  if (turn_about_one_axis(from, to)) return to.angle * to.axis - from.angle * from.axis;
  const Eigen::AngleAxisd shortest(to.quaternion() * from.quaternion().conjugate());
  return shortest.angle() * shortest.axis();
}

Pose pose_at(const Motion& motion, double time) {
  PLIANT_ASSERT(motion.keyframes.size() == motion.times.size(), "one keyframe for each time");
  const auto [before, fraction] = place_among(motion.times, motion.interpolation, time);
  const MotionKeyframe& from = motion.keyframes[static_cast<std::size_t>(before)];
  Eigen::Vector3d translation = from.translation;
  Pose pose{from.rotation, {}};
  if (fraction > 0) {
    const MotionKeyframe& to = motion.keyframes[static_cast<std::size_t>(before) + 1];
    translation += fraction * (to.translation - from.translation);
    pose.rotation = (quaternion_of(fraction * to.turn) * from.rotation).normalized();
  }
  pose.translation = motion.pivot - pose.rotation * motion.pivot + translation;
  return pose;
}

}  // namespace pliant
