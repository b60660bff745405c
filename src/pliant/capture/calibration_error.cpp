#include "pliant/capture/calibration_error.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "pliant/capture/bundle_adjustment.h"

namespace pliant {
namespace {

using NumberSlope = Eigen::Matrix<double, 2, kCameraNumbers>;

/// Of the pixel that shows a point by the camera's numbers.
NumberSlope slope_by_numbers(const CameraModel& camera, const Eigen::Vector3d& point,
                             const Projection& seen) {
  constexpr double kStep = 1e-6;  // rad, m: derivatives are smooth far beyond
  NumberSlope slope;
  slope.leftCols<kIntrinsics>() = seen.by_intrinsics;
  for (Eigen::Index k = 0; k < 6; ++k) {
    CameraModel before = camera, after = camera;
    (k < 3 ? before.pose.rotation(k) : before.pose.translation(k - 3)) -= kStep;
    (k < 3 ? after.pose.rotation(k) : after.pose.translation(k - 3)) += kStep;
    const auto low = before.project(point), high = after.project(point);
    slope.col(kIntrinsics + k).setZero();
    if (low && high) slope.col(kIntrinsics + k) = (*high - *low) / (2 * kStep);
  }
  return slope;
}

}  // namespace

CalibrationError::CalibrationError(const std::vector<CameraModel>& cameras,
                                   const Eigen::MatrixXd& covariance)
    : cameras_(cameras) {
  constexpr double kSmallest = 1e-12;  // of the scaled covariance
  // Numbers of different units are scaled by their own errors first.
  const Eigen::VectorXd sd = covariance.diagonal().cwiseMax(0).cwiseSqrt();
  const Eigen::VectorXd inverse = sd.unaryExpr([](double s) { return s > 0 ? 1 / s : 0.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> split(inverse.asDiagonal() * covariance *
                                                             inverse.asDiagonal());
  const Eigen::Index modes = (split.eigenvalues().array() > kSmallest).count();
  errors_ = sd.asDiagonal() * split.eigenvectors().rightCols(modes) *
            split.eigenvalues().tail(modes).cwiseSqrt().asDiagonal();
}

Eigen::Matrix3Xd CalibrationError::at(const Eigen::Vector3d& point,
                                      const std::vector<bool>& used) const {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix3Xd right = Eigen::Matrix3Xd::Zero(3, modes());
  for (std::size_t c = 0; c < cameras_.size(); ++c) {
    if (!used[c]) continue;
    const auto seen = cameras_[c].project_with_derivatives(point);
    if (!seen) continue;
    normal += seen->by_point.transpose() * seen->by_point;
    right += seen->by_point.transpose() * slope_by_numbers(cameras_[c], point, *seen) *
             errors_.middleRows<kCameraNumbers>(kCameraNumbers * static_cast<Eigen::Index>(c));
  }
  return -normal.ldlt().solve(right);
}

CameraModel CalibrationError::camera(std::size_t number, Eigen::Index mode) const {
  const Eigen::Vector<double, kCameraNumbers> off =
      errors_.col(mode).segment<kCameraNumbers>(kCameraNumbers * static_cast<Eigen::Index>(number));
  CameraModel camera = cameras_[number];
  camera.intrinsics += off.head<kIntrinsics>();
  camera.pose.rotation += off.segment<3>(kIntrinsics);
  camera.pose.translation += off.tail<3>();
  return camera;
}

}  // namespace pliant
