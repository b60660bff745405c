#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include <Eigen/Core>

namespace pliant {

/// Light or reflectance: linear red, green and blue of the sRGB primaries, 1 = white.
using Colour = Eigen::Vector3f;

/// A colour as pictures store it: sRGB encoded (IEC 61966-2-1).
using Pixel = std::array<std::uint8_t, 3>;

/// The colour of a web notation, e.g. 0x4a6fa5.
Colour colour_of_rgb(std::uint32_t rgb);

/// The colour of "#rrggbb"; none where `text` is something else.
std::optional<Colour> parse_colour(std::string_view text);

/// The nearest pixel; what is below 0 or above 1 is clamped.
Pixel encode_srgb(const Colour& colour);
Colour decode_srgb(const Pixel& pixel);

}  // namespace pliant
