#pragma once

#include <Eigen/Core>

#include "pliant/capture/pattern.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// The print on cloth.
class ClothPrint {
 public:
  /// @param columns, rows, pixel  as of WaveletNoise; the middle of the first pixel is the origin
  ClothPrint(const ClothPattern& pattern, int columns, int rows, double pixel);

  /// Brightness, 0 to 1; beyond the print that of its rim.
  /// @param place  m
  double at(const Eigen::Vector2d& place) const;

 private:
  double pixel_;
  SplinePicture picture_;
};

}  // namespace pliant
