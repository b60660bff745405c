#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace pliant {

/// The bytes of a PNG file of 8-bit grey levels that tells its physical resolution (chunk pHYs).
/// @param levels            row by row from the upper left pixel, 0 black
/// @param columns, rows     pixels
/// @param pixels_per_metre  > 0
std::string grey_png_bytes(std::span<const std::uint8_t> levels, int columns, int rows,
                           double pixels_per_metre);

}  // namespace pliant
