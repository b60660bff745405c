#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/rig_calibration.h"
#include "pliant/io/document.h"

namespace pliant {

/// What the use of calibrated cameras needs: a calibration/1 document (docs/formats/rig.md).
struct CalibratedRig {
  std::string file;
  std::vector<std::string> names;
  std::vector<CameraModel> cameras;
  std::vector<double> noise;               ///< of a coordinate of a corner, by camera (pixels)
  std::vector<double> rms;                 ///< reprojection, by camera (pixels)
  Eigen::MatrixXd covariance;              ///< of kCameraNumbers of each camera in turn
  std::optional<Eigen::Vector3d> gravity;  ///< its direction, unit, rig axes
  std::vector<std::string> warnings;
};

/// @throws InputError
CalibratedRig read_calibration(const std::filesystem::path& path);
CalibratedRig calibration_of(const Document& document);

/// The calibration/1 document of a calibration, JSON.
std::string calibration_text(const RigCalibration& calibration, const RigFile& rig);

/// A table of all corners: camera, picture, board, corner, where it was seen, how far it misses,
/// and whether it was used.
std::string corners_table(const RigCalibration& calibration, const RigFile& rig);

}  // namespace pliant
