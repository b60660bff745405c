#include "pliant/capture/rig_calibration.h"

#include <chrono>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/virtual_rig.h"

namespace pliant {
namespace {

using test::VirtualRig;
using ::testing::HasSubstr;

// Differences from the truth over their standard errors.
std::vector<double> errors_apart(const RigCalibration& found, const VirtualRig& rig) {
  std::vector<double> result;
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    const CameraModel &is = found.bundle.cameras[c], &was = rig.cameras[c];
    Eigen::Vector<double, kCameraNumbers> off;
    off << is.intrinsics - was.intrinsics, is.pose.rotation - was.pose.rotation,
        is.pose.translation - was.pose.translation;
    for (int k = 0; k < kCameraNumbers; ++k) {
      const double error = found.error(c, k);
      if (error > 0) result.push_back(off(k) / error);
    }
  }
  return result;
}

TEST(RigCalibration, FindsAVirtualRigWithinItsErrors) {
  const VirtualRig rig(2);
  const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(12, RandomStream(1)), {});
  for (const double apart : errors_apart(found, rig)) EXPECT_LT(std::abs(apart), 3.5);
  EXPECT_NEAR(found.bundle.noise[0], rig.noise, 0.1 * rig.noise);
  ASSERT_EQ(found.pairs.size(), 1u);
  EXPECT_NEAR(found.pairs[0].rms, rig.noise * std::sqrt(2.0), 0.2 * rig.noise);
  ASSERT_TRUE(found.held_out);
  EXPECT_LT(found.held_out->rms, 1e-4);
  std::cout << found.held_out->rms << " " << found.error(0, 0) << " " << found.error(1, 12) << "\n";
  for (const auto& w : found.warnings) std::cout << w << "\n";
}

TEST(SlowRigCalibration, StatesErrorsThatCoverTheTruth) {
  int inside = 0, all = 0;
  for (int seed = 0; seed < 20; ++seed) {
    const VirtualRig rig(2);
    const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(8, RandomStream(seed)), {});
    for (const double apart : errors_apart(found, rig)) {
      inside += std::abs(apart) < 1.96;
      ++all;
    }
  }
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 0.04) << inside << " of " << all;
  std::cout << inside << " of " << all << "\n";
}

TEST(SlowRigCalibration, TakesFourCamerasWithThirtyPicturesEach) {
  const VirtualRig rig(4);
  const auto begun = std::chrono::steady_clock::now();
  RunContext context;
  context.threads = 2;
  const RigCalibration found = calibrate_rig(rig.rig, rig.pictures(30, RandomStream(1)), context);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
  for (const double apart : errors_apart(found, rig)) EXPECT_LT(std::abs(apart), 4);
  std::cout << "4 cameras x 30 pictures: " << took.count() << " s\n";
}

}  // namespace
}  // namespace pliant
