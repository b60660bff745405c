#include "pliant/capture/virtual_rig.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/capture/calibration_file.h"

namespace pliant {

std::string virtual_camera_name(int number) { return fmt::format("camera{}", number + 1); }

std::vector<CameraModel> virtual_rig(const VirtualCameras& options, const Eigen::Vector2d& middle) {
  std::vector<CameraModel> cameras;
  const double focal = options.distance / options.pixel;
  for (int c = 0; c < options.count; ++c) {
    CameraModel camera;
    camera.columns = options.columns;
    camera.rows = options.rows;
    camera.intrinsics << focal * (1 + 0.004 * c), focal * (1.0015 + 0.004 * c),
        options.columns / 2.0 + 3 * c, options.rows / 2.0 - 2 * c, -0.12 + 0.01 * c, 0.05, 0.0004,
        -0.0003, 0;
    const double around = 2 * std::numbers::pi * (c - 0.5) / options.count;
    const Eigen::Vector3d target(middle.x(), middle.y(), 0);
    const Eigen::Vector3d out(std::sin(options.angle) * std::cos(around),
                              std::sin(options.angle) * std::sin(around), std::cos(options.angle));
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear().row(2) = -out;
    pose.linear().row(0) = Eigen::Vector3d::UnitY().cross(out).normalized();
    pose.linear().row(1) = pose.linear().row(2).cross(pose.linear().row(0));
    pose.translation() = -pose.linear() * (target + options.distance * out);
    camera.pose = RigidMotion::of(pose);
    cameras.push_back(camera);
  }
  return cameras;
}

std::string true_calibration_text(const std::vector<CameraModel>& cameras) {
  RigCalibration truth;
  const RigidMotion to_sheet = cameras.front().pose.inverse();
  for (const CameraModel& camera : cameras) {
    truth.names.push_back(virtual_camera_name(static_cast<int>(truth.names.size())));
    truth.bundle.cameras.push_back(camera);
    truth.bundle.cameras.back().pose = camera.pose * to_sheet;
  }
  truth.bundle.noise.assign(cameras.size(), 0);
  truth.cameras.resize(cameras.size());
  const auto numbers = kCameraNumbers * static_cast<Eigen::Index>(cameras.size());
  truth.covariance.cameras = Eigen::MatrixXd::Zero(numbers, numbers);
  truth.gravity = {-cameras.front().pose.matrix().col(2), 0};
  RigFile rig;
  rig.file = "rig.yaml";
  return calibration_text(truth, rig);
}

}  // namespace pliant
