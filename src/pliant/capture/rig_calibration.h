#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/capture/rig_checks.h"
#include "pliant/capture/rig_pictures.h"

namespace pliant {

/// A calibrated rig and what is to be known of it. Its axes are those of the first camera: x along
/// the rows of its pictures, y down, z away from it.
struct RigCalibration {
  std::vector<std::string> names;  ///< of the cameras
  Bundle bundle;
  BundleCovariance covariance;
  std::vector<RigPicture> pictures;
  std::vector<CameraResiduals> cameras;
  std::vector<EpipolarResidual> pairs;
  std::optional<HeldOutBoards> held_out;
  std::optional<LengthCheck> length;
  std::optional<RigGravity> gravity;
  std::vector<std::string> warnings;

  /// Standard error of one of a camera's numbers (kCameraNumbers).
  double error(int camera, int number) const;
  /// How far two cameras are from each other (m).
  double apart(const EpipolarResidual& pair) const;
};

/// Calibrates from what was found in the pictures.
/// @throws InputError where the pictures contradict each other or do not tell the cameras
/// @throws SolverError, Interrupted
RigCalibration calibrate_rig(const RigFile& rig, std::vector<RigPicture> pictures,
                             const RunContext& context);

}  // namespace pliant
