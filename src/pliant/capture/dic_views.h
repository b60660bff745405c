#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/dic_reference.h"
#include "pliant/capture/quadrilateral.h"

namespace pliant {

/// Pictures of a sample by several calibrated cameras at once.
struct DicViews {
  DicReference calibration;                               ///< calibration/1
  std::vector<std::string> names;                         ///< of the cameras
  std::vector<std::vector<std::filesystem::path>> files;  ///< by camera: one a frame
  /// Of the sample in the first picture of the first camera (pixels): of least u and v, of largest
  /// u, of largest u and v, of largest v.
  Quadrilateral corners;
  int patch = 21, step = 10;  ///< as of DicPictures
  // Of the calibration:
  std::vector<CameraModel> cameras;
  Eigen::MatrixXd covariance;           ///< of kCameraNumbers of each camera in turn
  std::optional<Eigen::Vector3d> down;  ///< along gravity, rig axes, unit
};

/// `views` of a dic/1 file; what the calibration tells is not there yet.
/// @throws InputError
DicViews read_views(const Value& value);
/// Refuses a calibration that the first pictures contradict.
/// @param file  that names it
/// @throws InputError
[[noreturn]] void refuse_calibration(const std::string& file, const std::string& why);
/// Takes over what the calibration tells.
/// @throws InputError
void resolve_views(DicViews& views);

}  // namespace pliant
