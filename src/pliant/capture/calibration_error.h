#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/capture/camera_model.h"

namespace pliant {

/// By how much points that cameras see lie elsewhere because the calibration has errors.
///
/// The covariance of all cameras' numbers is split into independent errors of one standard
/// deviation each; to first order a point moves by -(A^T A)^-1 A^T P e under one of them, A and P
/// being the derivatives of the pixels by the point and by the numbers.
class CalibrationError {
 public:
  CalibrationError() = default;
  /// @param covariance  of kCameraNumbers of each camera in turn
  CalibrationError(const std::vector<CameraModel>& cameras, const Eigen::MatrixXd& covariance);

  /// How many independent errors there are; 0 of a calibration without errors.
  Eigen::Index modes() const { return errors_.cols(); }
  /// Displacements of a point by each of them (m).
  /// @param used  by camera: whether it sees the point
  Eigen::Matrix3Xd at(const Eigen::Vector3d& point, const std::vector<bool>& used) const;
  /// A camera under one of them.
  CameraModel camera(std::size_t number, Eigen::Index mode) const;

 private:
  std::vector<CameraModel> cameras_;
  Eigen::MatrixXd errors_;  // numbers x modes
};

}  // namespace pliant
