#pragma once

#include <optional>
#include <utility>

#include <Eigen/Core>

#include "pliant/capture/camera_model.h"

namespace pliant {

/// What a lens does to pictures: pixels as they are, and where a pinhole with the same focal length
/// and principal point would show the same. Without a calibration the lens is taken for a pinhole.
class Lens {
 public:
  Lens() = default;
  explicit Lens(CameraModel camera) : camera_(std::move(camera)) {}

  const std::optional<CameraModel>& camera() const { return camera_; }

  /// @param seen  2 x pixels
  /// @throws InputError for pixels at which the calibration knows no direction
  Eigen::Matrix2Xd straightened(const Eigen::Matrix2Xd& seen) const;
  /// @param straight  2 x pixels of the pinhole
  Eigen::Matrix2Xd seen(const Eigen::Matrix2Xd& straight) const;

 private:
  std::optional<CameraModel> camera_;
};

}  // namespace pliant
