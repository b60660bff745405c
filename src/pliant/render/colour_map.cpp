#include "pliant/render/colour_map.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace pliant {
namespace {

// Evenly spaced points; linear between them in sRGB, as the maps are defined. Against the 256
// colours of the originals the error is at most 2 (viridis) and 8 (coolwarm) of 255.
constexpr std::uint32_t kViridis[] = {
    0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453781, 0x424086, 0x3e4989, 0x3b528b,
    0x375b8d, 0x33638d, 0x2f6b8e, 0x2c728e, 0x297a8e, 0x26828e, 0x23898e, 0x21918c, 0x1f978b,
    0x1f9f88, 0x21a685, 0x27ad81, 0x31b57b, 0x3dbc74, 0x4cc26c, 0x5cc863, 0x6ece58, 0x81d34d,
    0x95d840, 0xaadc32, 0xc0df25, 0xd5e21a, 0xeae51a, 0xfde725};
constexpr std::uint32_t kCoolwarm[] = {0x3b4cc0, 0x4e68d8, 0x6282ea, 0x779af7, 0x8db0fe, 0xa3c2fe,
                                       0xb9d0f9, 0xccd9ed, 0xdddcdc, 0xebd3c6, 0xf4c5ad, 0xf7b194,
                                       0xf49a7b, 0xec7f63, 0xde614d, 0xcb3e38, 0xb40426};
constexpr std::uint32_t kNoValue = 0xc8c8c8;

std::span<const std::uint32_t> points_of(ColourMap map) {
  if (map == ColourMap::coolwarm) return kCoolwarm;
  return kViridis;
}

std::uint8_t between(std::uint32_t a, std::uint32_t b, int shift, double t) {
  const double from = (a >> shift) & 0xffU, to = (b >> shift) & 0xffU;
  return static_cast<std::uint8_t>(std::lround(from + t * (to - from)));
}

}  // namespace

Colour map_colour(ColourMap map, double position) {
  const std::span<const std::uint32_t> points = points_of(map);
  const double at = std::clamp(position, 0.0, 1.0) * static_cast<double>(points.size() - 1);
  const size_t i = std::min(static_cast<size_t>(at), points.size() - 2);
  const double t = at - static_cast<double>(i);
  const std::uint32_t a = points[i], b = points[i + 1];
  return decode_srgb({between(a, b, 16, t), between(a, b, 8, t), between(a, b, 0, t)});
}

Colour ColourScale::colour(double value) const {
  if (std::isnan(value)) return colour_of_rgb(kNoValue);
  return map_colour(map, high > low ? (value - low) / (high - low) : 0.5);
}

}  // namespace pliant
