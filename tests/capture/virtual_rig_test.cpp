#include "pliant/capture/virtual_rig.h"

#include <gtest/gtest.h>

#include "pliant/capture/calibration_file.h"
#include "pliant/io/document.h"

namespace pliant {
namespace {

TEST(TrueCalibration, HasTheCamerasInAxesOfTheFirst) {
  const std::vector<CameraModel> cameras = virtual_rig({}, {0.05, 0.04});
  const CalibratedRig truth =
      calibration_of(parse_json(true_calibration_text(cameras), "truth.json"));
  EXPECT_EQ(truth.names.back(), "camera4");
  EXPECT_TRUE(truth.covariance.isZero());
  EXPECT_LT(truth.cameras.front().pose.translation.norm(), 1e-12);
  const Eigen::Vector3d on_sheet(0.03, 0.02, 0.01);
  const Eigen::Vector3d in_rig = cameras.front().pose * on_sheet;
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    // Numbers are written in seventeen digits, poses are multiplied once.
    EXPECT_LT((*truth.cameras[c].project(in_rig) - *cameras[c].project(on_sheet)).norm(), 1e-8);
  }
  const Eigen::Vector3d down = cameras.front().pose * Eigen::Vector3d(0.03, 0.02, 0) - in_rig;
  ASSERT_TRUE(truth.gravity);
  EXPECT_LT((*truth.gravity - down.normalized()).norm(), 1e-12);
}

}  // namespace
}  // namespace pliant
