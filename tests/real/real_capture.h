#pragma once

#include <string>

#include "pliant/capture/rig_calibration.h"

namespace pliant::test {

/// Cameras by pictures of a chessboard, as `pliant calibrate` finds them.
/// @param board, cameras, pictures  as in pattern/1 and rig/1
RigCalibration calibrated(const std::string& board, const std::string& cameras,
                          const std::string& pictures);

int left_out_pictures(const RigCalibration& found);

}  // namespace pliant::test
