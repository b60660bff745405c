#include "pliant/capture/calibration_error.h"

#include <gtest/gtest.h>

#include "pliant/capture/triangulation.h"

#include "capture/drawn_rig.h"

namespace pliant {
namespace {

/// Sightings of a point, by other cameras than those that took the pictures.
Eigen::Vector3d seen_by(const std::vector<CameraModel>& taken,
                        const std::vector<CameraModel>& believed, const Eigen::Vector3d& point) {
  std::vector<Sighting> sightings;
  for (std::size_t c = 0; c < taken.size(); ++c) {
    sightings.push_back({&believed[c], *taken[c].project(point), 1});
  }
  return triangulate(sightings)->point;
}

TEST(CalibrationError, MovesPointsAsCamerasWithThatErrorDo) {
  const std::vector<CameraModel> cameras = test::DrawnRig(3, 480, 420, 0.06).cameras;
  Eigen::VectorXd sd(45);
  for (int c = 0; c < 3; ++c) {
    sd.segment<15>(15 * c) << 0.3, 0.3, 0.2, 0.2, 1e-3, 1e-3, 1e-5, 1e-5, 0, 5e-5, 5e-5, 5e-5, 2e-5,
        2e-5, 2e-5;
  }
  const CalibrationError error(cameras, sd.cwiseAbs2().asDiagonal().toDenseMatrix());
  EXPECT_EQ(error.modes(), 42);  // k3 of none is free
  const SightRay ray = *cameras[0].ray({260, 190});
  const Eigen::Vector3d point = ray.from + 0.49 * ray.direction;
  const Eigen::Matrix3Xd moved = error.at(point, {true, true, true});
  for (Eigen::Index mode = 0; mode < error.modes(); ++mode) {
    std::vector<CameraModel> off;
    for (std::size_t c = 0; c < cameras.size(); ++c) off.push_back(error.camera(c, mode));
    const Eigen::Vector3d change = seen_by(cameras, off, point) - point;
    EXPECT_LT((change - moved.col(mode)).norm(), 0.02 * change.norm() + 1e-9) << mode;
  }
}

TEST(CalibrationError, IsNoneOfAPerfectCalibration) {
  const std::vector<CameraModel> cameras = test::DrawnRig(2, 480, 420, 0.06).cameras;
  EXPECT_EQ(CalibrationError(cameras, Eigen::MatrixXd::Zero(30, 30)).modes(), 0);
}

}  // namespace
}  // namespace pliant
