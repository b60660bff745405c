#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/geometry/simulation_frames.h"
#include "pliant/render/colour_map.h"
#include "pliant/render/render.h"
#include "pliant/render/simulation_pictures.h"

namespace pliant {

/// Of one picture or sheet.
inline constexpr long kMostPixels = 200'000'000;

/// "800x600": width and height in pixels.
/// @throws InputError
PictureSize parse_picture_size(const std::string& text);

/// "#rrggbb".
/// @param option  as the user wrote it, for the message
/// @throws InputError
Colour parse_colour_option(const std::string& option, const std::string& text);

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

/// "x=0.02" or "z = 5 mm".
/// @throws InputError
AxisPlane parse_cut(const std::string& text);

/// The frames that "FIRST:LAST:STEP" asks for: every STEP-th of those numbered FIRST to LAST. Parts
/// may be left out ("10:", "::5"); a number alone is that frame; an empty text means all.
/// @throws InputError, also where that is none
std::vector<SimulationFrame> select_frames(const std::vector<SimulationFrame>& frames,
                                           const std::string& text);

/// "50 mm", above 0, in metres.
/// @throws InputError
double parse_line_spacing(const std::string& text);

/// How fast a film shows its frames.
struct FilmRate {
  double pictures = 0;  ///< a second
  double speed = 1;     ///< against reality

  /// "10 a second" and, where it is not that of reality, the speed.
  std::string text() const;
};

/// @param rate  that the user wants; 0: that of reality, but between 1 and 60 pictures a second
FilmRate film_rate(const std::vector<SimulationFrame>& frames, double rate);

}  // namespace pliant
