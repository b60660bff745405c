#pragma once

#include <string>

#include "pliant/report/sheet_session.h"

namespace pliant::report {

/// Residual vectors are drawn so many times as long as they are ([T] Fig. 3.6).
inline constexpr double kResidualMagnification = 5;

/// A frame as a picture in SVG: measured and predicted sheet, coloured by the position residual,
/// with the forces of their clips. It needs no script, and is what is printed.
/// @param largest_residual  of the colour scale (m)
std::string sheet_picture(const SheetSession& sheet, int frame, double largest_residual);

/// The position residual of a frame as lines on the predicted sheet, in SVG.
std::string residual_picture(const SheetSession& sheet, int frame);

}  // namespace pliant::report
