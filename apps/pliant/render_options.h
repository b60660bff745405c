#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/render/camera.h"
#include "pliant/render/colour_map.h"
#include "pliant/render/render.h"
#include "pliant/render/simulation_frames.h"

namespace pliant {

/// Of one picture or sheet.
inline constexpr long kMostPixels = 200'000'000;

/// "800x600": width and height in pixels.
/// @throws InputError
PictureSize parse_picture_size(const std::string& text);

/// "front", "side", "top" or "three-quarter".
/// @throws InputError
ViewDirection parse_view(const std::string& text);

/// "viridis" or "coolwarm".
/// @throws InputError
ColourMap parse_colour_map(const std::string& text);

/// "X,Y,Z".
/// @param option  as the user wrote it, for the message
/// @throws InputError
Eigen::Vector3d parse_point(const std::string& option, const std::string& text);

/// "LOW:HIGH", LOW below HIGH.
/// @throws InputError
std::pair<double, double> parse_value_range(const std::string& text);

/// The frames that "FIRST:LAST:STEP" asks for: every STEP-th of those numbered FIRST to LAST. Parts
/// may be left out ("10:", "::5"); a number alone is that frame; an empty text means all.
/// @throws InputError, also where that is none
std::vector<SimulationFrame> select_frames(const std::vector<SimulationFrame>& frames,
                                           const std::string& text);

}  // namespace pliant
