#pragma once

#include <string>

#include "pliant/capture/pattern.h"
#include "pliant/capture/sheet_canvas.h"

namespace pliant {

/// Most pixels along a side of a picture.
inline constexpr int kMostSheetPixels = 32'000;
/// Least pixels of a cloth's noise in its finest length.
inline constexpr int kLeastNoisePixels = 4;

/// Draws a pattern on its sheet in its true size, with a ruler below it, and an arrow along the
/// weft beside that of cloth: the bytes of a file.
/// @param dpi  of a PNG; of noise it is the pattern's own
/// @throws InputError where the sheet does not hold the pattern, or where pixels are too many, or
///         too large for the noise
std::string draw_pattern(const Pattern& pattern, SheetFormat format, double dpi);

}  // namespace pliant
