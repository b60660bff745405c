#include "pliant/render/colour.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace pliant {
namespace {

float decode_channel(std::uint8_t byte) {
  const float value = static_cast<float>(byte) / 255.0F;
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

std::uint8_t encode_channel(float linear) {
  const float x = std::clamp(linear, 0.0F, 1.0F);
  const float value = x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(255.0F * value));
}

Pixel pixel_of_rgb(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
          static_cast<std::uint8_t>(rgb)};
}

}  // namespace

Colour colour_of_rgb(std::uint32_t rgb) { return decode_srgb(pixel_of_rgb(rgb)); }

std::optional<Colour> parse_colour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::uint32_t rgb = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, rgb, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  return colour_of_rgb(rgb);
}

Pixel encode_srgb(const Colour& colour) {
  return {encode_channel(colour.x()), encode_channel(colour.y()), encode_channel(colour.z())};
}

Colour decode_srgb(const Pixel& pixel) {
  return {decode_channel(pixel[0]), decode_channel(pixel[1]), decode_channel(pixel[2])};
}

}  // namespace pliant
