// Bodies whose corners several cameras see, some of them hidden by what passes before them.
#include "pliant/capture/sighted_pose.h"

#include <gtest/gtest.h>

#include "capture/virtual_rig.h"

namespace pliant {
namespace {

using test::VirtualRig;

const Pose kMoved{
    Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 2, -1).normalized())),
    {0.004, -0.01, 0.006}};

/// Two labels at the ends of a bar of 80 mm, by four cameras.
std::vector<BodySighting> sightings(const VirtualRig& rig, double noise) {
  RandomStream random(3);
  std::vector<BodySighting> result;
  for (const CameraModel& camera : rig.cameras) {
    for (const double end : {-0.034, 0.034}) {
      for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        const Eigen::Vector3d point(end + 0.006 * x, 0.006 * y, 0.5);
        const Eigen::Vector2d off = noise * Eigen::Vector2d(random.normal(), random.normal());
        result.push_back({&camera, point, *camera.project(kMoved.apply(point)) + off});
      }
    }
  }
  return result;
}

/// Of the ends of the bar (m).
double miss(const Pose& pose) {
  double most = 0;
  for (const double end : {-0.04, 0.04}) {
    const Eigen::Vector3d point(end, 0, 0.5);
    most = std::max(most, (pose.apply(point) - kMoved.apply(point)).norm());
  }
  return most;
}

const Pose kNear{
    Eigen::Quaterniond(Eigen::AngleAxisd(0.15, Eigen::Vector3d(1, 2, -1).normalized())),
    {0.003, -0.008, 0.004}};

TEST(SightedPose, IsExactWithoutNoise) {
  const VirtualRig rig(4);
  EXPECT_LT(miss(sighted_pose(sightings(rig, 0), kNear, 0.03)), 1e-8);
}

TEST(SightedPose, IsWithinItsNoise) {
  const VirtualRig rig(4);
  EXPECT_LT(miss(sighted_pose(sightings(rig, 0.03), kNear, 0.03)), 0.03e-3);
}

// A cord before a label moves the corners that its edges meet in, by pixels.
TEST(SightedPose, LeavesOutCornersThatAreHidden) {
  const VirtualRig rig(4);
  std::vector<BodySighting> seen = sightings(rig, 0.03);
  const double clear = miss(sighted_pose(seen, kNear, 0.03));
  for (const std::size_t hidden : {0, 1, 13}) seen[hidden].pixel += Eigen::Vector2d(1.1, 3);
  EXPECT_LT(miss(sighted_pose(seen, kNear, 0.03)), clear + 0.02e-3);
}

}  // namespace
}  // namespace pliant
