#pragma once

#include <string>
#include <vector>

#include "pliant/capture/camera_model.h"
#include "pliant/study/virtual_cameras.h"

namespace pliant {

/// The name of one of the cameras of a lab.
std::string virtual_camera_name(int number);

/// Cameras on a circle above the middle of a sheet in the plane z = 0, of which the first lies
/// towards the lower right; their lenses are a little different. Axes are those of the sheet.
/// @param middle  of the sheet (m)
std::vector<CameraModel> virtual_rig(const VirtualCameras& options, const Eigen::Vector2d& middle);

/// What a calibration of such cameras without any error would write: a calibration/1 document,
/// whose axes are those of the first camera, and whose errors are 0.
/// @param cameras  in the axes of the sheet
std::string true_calibration_text(const std::vector<CameraModel>& cameras);

}  // namespace pliant
