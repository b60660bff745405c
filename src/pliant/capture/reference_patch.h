#pragma once

#include <optional>

#include <Eigen/Core>

#include "pliant/capture/spline_picture.h"

namespace pliant {

/// Smoothing of pictures in which patches are looked for (SplinePicture).
inline constexpr double kMatchSmoothing = 0.125;
/// Correlation from which on a patch counts as found.
inline constexpr double kAlike = 0.75;

/// How a patch has moved: a place d off its middle is at `shift + slope d` beyond where it was.
struct PatchMotion {
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< of its middle (pixels)
  Eigen::Matrix2d slope = Eigen::Matrix2d::Zero();
};

/// A patch that was found in another picture.
struct PatchMatch {
  PatchMotion motion;
  double correlation =
      0;             ///< of both patches, brightness and contrast apart: 1 where they are equal
  double noise = 0;  ///< standard deviation of a pixel in either picture, by what is left
  Eigen::Matrix2d covariance;  ///< of the shift, by that noise (pixels^2)
  int iterations = 0;
};

/// A square of a picture that is looked for in others: its motion there is affine, its brightness
/// and contrast may change.
///
/// Zero-mean normalised squared differences are minimised by Gauss and Newton's method in its
/// inverse compositional form [Baker2004], [Pan2013]: derivatives are those of the reference, which
/// are made once. Those by brightness and contrast are projected out.
class ReferencePatch {
 public:
  /// @param place   middle of the patch (column, row)
  /// @param radius  the patch has 2 radius + 1 pixels a side, > 0
  /// @return nothing where the patch leaves the picture, or has too little texture to be found
  static std::optional<ReferencePatch> of(const SplinePicture& picture,
                                          const Eigen::Vector2d& place, int radius);

  /// Finds it in a picture.
  /// @param start  within some pixels of its motion
  /// @return nothing where the search leaves the picture or does not end
  std::optional<PatchMatch> match(const SplinePicture& picture, const PatchMotion& start) const;
  /// Of both patches, if it had moved so; nothing where that leaves the picture, or shows nothing.
  std::optional<double> correlation(const SplinePicture& picture, const PatchMotion& motion) const;

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  ReferencePatch() = default;
  /// Sums of a number a pixel times d value / d motion, before brightness is projected out.
  Vector6 along_steps(const Eigen::ArrayXf& numbers) const;
  /// The same after it.
  Vector6 along_free_steps(const Eigen::ArrayXf& numbers) const;
  bool sample(const SplinePicture& picture, const PatchMotion& motion,
              Eigen::ArrayXf& values) const;

  Eigen::Vector2d place_ = Eigen::Vector2d::Zero();
  int radius_ = 0;
  double noise_left_ = 1;            // of the variance of its picture's pixels
  Eigen::ArrayXf values_;            // less their mean, row by row
  double norm_ = 0;                  // of them
  Eigen::ArrayXf across_, down_;     // gradients: thousands of patches are kept, and these alone
  Vector6 mean_step_, bright_step_;  // what brightness and contrast do of a step
  Eigen::Matrix<double, 6, 6> inverse_;  // of the steps' normal matrix
};

}  // namespace pliant
