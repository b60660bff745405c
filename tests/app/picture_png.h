#pragma once

#include <string>

#include "pliant/capture/grey_png.h"

namespace pliant::test {

/// A PNG file of a picture.
/// @param white  its brightness
inline std::string png_of(const GreyPicture& picture, float white = 1) {
  constexpr double kPixelsPerMetre = 4000;
  return grey_png_bytes(picture / white, kPixelsPerMetre);
}

}  // namespace pliant::test
