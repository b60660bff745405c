#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "pliant/capture/spline_picture.h"
#include "pliant/render/png.h"

namespace pliant::test {

/// A PNG file of a picture.
/// @param white  its brightness
inline std::string png_of(const GreyPicture& picture, double white = 1) {
  Image image(static_cast<int>(picture.cols()), static_cast<int>(picture.rows()));
  for (int row = 0; row < image.height(); ++row) {
    for (int column = 0; column < image.width(); ++column) {
      const double share = static_cast<double>(picture(row, column)) / white;
      const auto level = static_cast<std::uint8_t>(std::clamp(std::lround(255 * share), 0L, 255L));
      image.at(column, row) = {level, level, level};
    }
  }
  return png_bytes(image);
}

}  // namespace pliant::test
