#pragma once

#include <nlohmann/json.hpp>

#include "pliant/report/sheet_session.h"

namespace pliant::report {

/// What the script of the three-dimensional views draws a session from (web/src/sheets.js).
///
/// Coordinates are 16-bit steps of `step` from `low` (m): a hundredth of what cameras see, in half
/// the bytes of floats. Numbers of nodes are base64 of little-endian integers.
/// @param most_frames  of those frames, evenly, and the most distorted one
nlohmann::json sheet_view(const SheetSession& sheet, int most_frames);

/// The largest distance between a measured and a predicted free node of a session (m).
double largest_residual(const SheetSession& sheet);

}  // namespace pliant::report
