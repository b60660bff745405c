// Rigid motions by keyframes.

#include "pliant/scene/motion.h"

#include <numbers>

#include <gtest/gtest.h>

namespace pliant {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-14;

Rotation about(const Vector3d& axis, double degrees) {
  return {axis.normalized(), degrees * std::numbers::pi / 180};
}

/// As a quaternion states it: at most half a turn.
Rotation as_quaternion(const Rotation& rotation) {
  const Eigen::AngleAxisd same(rotation.quaternion());
  return {same.axis(), same.angle(), false};
}

/// From one rotation to the other in one second.
Motion turning(const Rotation& from, const Rotation& to) {
  Motion motion;
  motion.times = {0, 1};
  motion.keyframes = {{Vector3d::Zero(), from.quaternion(), Vector3d::Zero()},
                      {Vector3d::Zero(), to.quaternion(), turn_between(from, to)}};
  return motion;
}

void expect_same(const Eigen::Quaterniond& one, const Eigen::Quaterniond& other) {
  EXPECT_NEAR(one.angularDistance(other), 0, 1e-7);  // the arc cosine's rounding near 1
}

TEST(Motion, MeetsItsKeyframes) {
  const Rotation from = about({1, 2, 3}, 50), to = about({-1, 0.5, 2}, 130);
  const Motion motion = turning(from, to);
  expect_same(pose_at(motion, 0).rotation, from.quaternion());
  expect_same(pose_at(motion, 1 - 1e-12).rotation, to.quaternion());
  expect_same(pose_at(motion, 1).rotation, to.quaternion());
}

TEST(Motion, TurnsLikeSphericalLinearInterpolation) {
  const Rotation from = about({1, 2, 3}, 50), to = about({-1, 0.5, 2}, 130);
  for (const double time : {0.1, 0.5, 0.9}) {
    expect_same(pose_at(turning(from, to), time).rotation,
                from.quaternion().slerp(time, to.quaternion()));
  }
}

TEST(Motion, ByAnglesAboutOneAxisMakesWholeTurns) {
  const Motion motion = turning(about({0, 0, 1}, 0), about({0, 0, 1}, 720));
  expect_same(pose_at(motion, 0.125).rotation, about({0, 0, 1}, 90).quaternion());
  expect_same(pose_at(motion, 0.5).rotation, about({0, 0, 1}, 360).quaternion());
}

TEST(Motion, ByQuaternionsTurnsTheShortestWay) {
  const Motion motion =
      turning(as_quaternion(about({0, 0, 1}, 170)), as_quaternion(about({0, 0, 1}, -170)));
  expect_same(pose_at(motion, 0.5).rotation, about({0, 0, 1}, 180).quaternion());
  EXPECT_NEAR(motion.keyframes[1].turn.norm(), 20 * std::numbers::pi / 180, kRounding);
}

TEST(Motion, LeavesItsPivotWhereItIs) {
  Motion motion = turning(about({0, 1, 0}, 0), about({0, 1, 0}, 90));
  motion.pivot = {1, 2, 3};
  EXPECT_LT((pose_at(motion, 0.3).apply(motion.pivot) - motion.pivot).norm(), kRounding);
  EXPECT_LT((pose_at(motion, 1).apply({2, 2, 3}) - Vector3d(1, 2, 2)).norm(), kRounding);
}

TEST(Motion, MovesItsPivotByTheTranslation) {
  Motion motion = turning(about({0, 1, 0}, 0), about({0, 1, 0}, 90));
  motion.pivot = {1, 2, 3};
  motion.keyframes[1].translation = {0, 0, 4};
  EXPECT_LT((pose_at(motion, 0.5).apply(motion.pivot) - Vector3d(1, 2, 5)).norm(), kRounding);
}

TEST(Motion, KeepsRotationsOfUnitLength) {
  const Motion motion = turning(about({1, 2, 3}, 50), about({-1, 0.5, 2}, 130));
  for (const double time : {0.1, 0.3, 0.77}) {
    EXPECT_NEAR(pose_at(motion, time).rotation.norm(), 1, kRounding);
  }
}

}  // namespace
}  // namespace pliant
