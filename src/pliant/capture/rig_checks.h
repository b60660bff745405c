#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pliant/capture/bundle_adjustment.h"
#include "pliant/capture/rig_file.h"
#include "pliant/capture/rig_pictures.h"

namespace pliant {

/// How well a camera's pictures are met.
struct CameraResiduals {
  int pictures = 0, corners = 0, left_out = 0;
  double rms = 0;      ///< of both coordinates of a corner together (pixels)
  double rms_all = 0;  ///< the same with the corners that were left out
  /// The same by ninths of the picture, row by row; nothing where no corner was seen.
  std::array<std::optional<double>, 9> regions;
  double widest_tilt = 0;  ///< largest angle between the normals of two boards that it saw (rad)
};

/// How well the corners that two cameras saw at once lie on each other's epipolar lines.
struct EpipolarResidual {
  int first = 0, second = 0;  ///< cameras
  int corners = 0;
  double rms = 0;  ///< distance of a corner from its line (pixels)
};

/// Boards whose pictures were left out, in turn, of a calibration, and were measured with it.
struct HeldOutBoards {
  int boards = 0, corners = 0;
  double rms = 0;          ///< distance of corners from the rigid board (m)
  double scale_error = 0;  ///< mean of measured over true size, less 1
};

/// What the second length came out as.
struct LengthCheck {
  int measured_in = 0;  ///< shots (of a side: sides)
  double stated = 0, measured = 0,
         error = 0;  ///< m; standard error of the mean, calibration included
  double errors_apart() const { return (measured - stated) / error; }
};

/// The direction of gravity.
struct RigGravity {
  Eigen::Vector3d direction;  ///< unit, rig axes
  double error = 0;           ///< rad, of one of its two angles
};

std::vector<CameraResiduals> camera_residuals(const Bundle& bundle);
std::vector<EpipolarResidual> epipolar_residuals(const Bundle& bundle);

/// Calibrates again without some of the boards, as often as it takes to leave out each once (at
/// most nine times), and triangulates their corners.
/// @return nothing where no board was seen by two cameras at once
std::optional<HeldOutBoards> held_out_boards(const Bundle& bundle, const BundleOptions& options);

/// Measures the second length in all shots that show it.
/// @throws InputError where no shot does
LengthCheck check_length(const SecondLength& length, const Bundle& bundle,
                         const std::vector<RigPicture>& pictures,
                         const BundleCovariance& covariance);

/// @throws InputError where the picture was not used
std::optional<RigGravity> gravity_of(const GravitySource& source, const Bundle& bundle,
                                     const std::vector<RigPicture>& pictures,
                                     const BundleCovariance& covariance);

}  // namespace pliant
