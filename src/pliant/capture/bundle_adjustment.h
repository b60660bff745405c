#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/progress.h"
#include "pliant/capture/camera_model.h"

namespace pliant {

/// Which of a camera's numbers are estimated; the others keep their start.
using FreeIntrinsics = std::array<bool, kIntrinsics>;

/// A board at one place, which several cameras may have seen.
struct BoardPlacement {
  int board = 0;
  RigidMotion pose;  ///< of the board in rig axes
};

/// Corners of a placed board in one camera's picture.
struct CornerView {
  int camera = 0, placement = 0;
  std::vector<int> corners;   ///< numbers of the board's corners
  Eigen::Matrix2Xd pixels;    ///< one column a corner
  std::vector<bool> is_used;  ///< of each corner; all at the start
  int picture = 0;            ///< of the caller's, for messages

  int used() const;
};

/// How a board is bent: out of its plane by a x^2 + b x y + c y^2, with x and y from its middle in
/// half widths and half heights.
using BoardWarp = Eigen::Vector3d;

/// A rig as far as pictures of boards tell it: the start of an adjustment, and its result.
struct Bundle {
  std::vector<CameraModel> cameras;      ///< the rig's axes are those of the first
  std::vector<FreeIntrinsics> free;      ///< by camera
  std::vector<double> noise;             ///< of a coordinate of a corner, by camera (pixels)
  std::vector<Eigen::Matrix3Xd> boards;  ///< corners (m)
  std::vector<BoardWarp> warps;          ///< by board (m)
  std::vector<BoardPlacement> placements;
  std::vector<CornerView> views;

  /// A corner of a placed board, in rig axes.
  Eigen::Vector3d corner(const BoardPlacement& placement, int number) const;
  /// Seen less predicted (pixels), one column a corner of the view, used or not.
  Eigen::Matrix2Xd residuals(const CornerView& view) const;
};

struct BundleOptions {
  bool warp = false;         ///< estimate how boards are bent
  bool fix_cameras = false;  ///< placements alone
  double outlier = 5;        ///< corners that miss by so many errors are left out
  int threads = 1;           ///< for calibrations beside each other; the result is the same
  StopToken stop;
};

/// What is known of the numbers that were estimated.
struct BundleCovariance {
  /// Of all cameras' numbers: nine intrinsics and six of the pose (rotation vector, translation)
  /// for each camera in turn; zero where they were not estimated.
  Eigen::MatrixXd cameras;
  std::vector<Eigen::Matrix<double, 6, 6>> placements;  ///< of each pose
  std::vector<Eigen::Matrix3d> warps;
  bool is_determined = true;  ///< else the rest is meaningless
};

inline constexpr int kCameraNumbers = kIntrinsics + 6;

/// Least squares over everything at once ([Triggs2000]), with Huber's loss while corners that miss
/// are found and left out, without one in the end. Noise of each camera is estimated from what is
/// left.
/// @throws SolverError, Interrupted
void adjust(Bundle& bundle, const BundleOptions& options = {});

/// The same from a start that is near, with the corners and the noise that it has.
/// @throws SolverError, Interrupted
void readjust(Bundle& bundle, const BundleOptions& options = {});

/// Covariance at the result of `adjust`, by the same options.
BundleCovariance covariance_of(Bundle& bundle, const BundleOptions& options = {});

}  // namespace pliant
