#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pliant/capture/spline_picture.h"

namespace pliant {

/// The bytes of a PNG file of 8-bit grey levels that tells its physical resolution (chunk pHYs).
/// @param levels            row by row from the upper left pixel, 0 black
/// @param columns, rows     pixels
/// @param pixels_per_metre  > 0
std::string grey_png_bytes(std::span<const std::uint8_t> levels, int columns, int rows,
                           double pixels_per_metre);

/// @param picture  brightness, 0 to 1; what is beyond is cut
std::string grey_png_bytes(const GreyPicture& picture, double pixels_per_metre);
/// The same of 16-bit grey levels, which it states to be linear in the light (gAMA 1).
std::string deep_grey_png_bytes(const GreyPicture& picture, double pixels_per_metre);

}  // namespace pliant
