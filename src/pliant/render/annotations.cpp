#include "pliant/render/annotations.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pliant/geometry/stroke_font.h"
#include "pliant/render/number_scale.h"

namespace pliant {
namespace {

constexpr int kTicks = 9;

/// Where the parts of a colour bar lie, in pixels.
struct BarLayout {
  float gap = 0;  // between the parts, and to the edge of the picture
  float bar_width = 0;
  float text_width = 0;  // of the widest label, or of what is wider above the bar

  float width() const { return bar_width + gap + text_width + 1.5F * gap; }
};

NumberScale numbers_of(const FieldLegend& legend) {
  return number_scale(legend.scale.low, legend.scale.high, kTicks);
}

std::string unit_text(const FieldLegend& legend, const NumberScale& numbers) {
  const std::string unit = legend.unit == "1" ? "" : legend.unit;
  if (numbers.exponent == 0) return unit.empty() ? "" : fmt::format("({})", unit);
  return fmt::format("(1e{}{}{})", numbers.exponent, unit.empty() ? "" : " ", unit);
}

/// What stands below the bar.
std::vector<std::string> note_lines(const FieldLegend& legend) {
  if (!legend.percentiles) return {};
  return {"2nd to 98th", "percentile"};
}

BarLayout layout_of(const FieldLegend& legend, const NumberScale& numbers, float cap_height) {
  BarLayout layout;
  layout.gap = cap_height;
  layout.bar_width = 1.6F * cap_height;
  for (const double tick : numbers.ticks) {
    layout.text_width = std::max(layout.text_width, text_width(numbers.label(tick), cap_height));
  }
  std::vector<std::string> lines = note_lines(legend);
  lines.insert(lines.end(), {legend.name, unit_text(legend, numbers)});
  for (const std::string& line : lines) {
    const float beyond_bar = text_width(line, cap_height) - layout.bar_width - layout.gap;
    layout.text_width = std::max(layout.text_width, beyond_bar);
  }
  return layout;
}

/// The bar's colours in whole pixels, with a thin frame.
void fill_bar(Image& image, const ColourScale& scale, const Eigen::Vector2i& corner,
              const Eigen::Vector2i& size, const Pixel& frame) {
  for (int y = 0; y < size.y(); ++y) {
    const double place = 1 - (y + 0.5) / size.y();
    const Pixel pixel = encode_srgb(map_colour(scale.map, place));
    for (int x = 0; x < size.x(); ++x) {
      const bool rim = x == 0 || y == 0 || x == size.x() - 1 || y == size.y() - 1;
      blend(image, corner.x() + x, corner.y() + y, rim ? frame : pixel, 1);
    }
  }
}

/// Place of a value along the bar, 0 at its lower end.
double place_of(const ColourScale& scale, double value) {
  return scale.high > scale.low ? (value - scale.low) / (scale.high - scale.low) : 0.5;
}

/// "10 cm"; in mm below 1 cm, in m from 1 m on.
std::string length_text(double length) {
  constexpr double kRounding = 1 - 1e-9;
  if (length >= kRounding) return fmt::format("{:g} m", length);
  if (length >= 0.01 * kRounding) return fmt::format("{:g} cm", 100 * length);
  return fmt::format("{:g} mm", 1000 * length);
}

}  // namespace

TextStyle label_style(int picture_height) {
  TextStyle style;
  style.cap_height = std::clamp(static_cast<float>(picture_height) / 54, 8.0F, 40.0F);
  return style;
}

int colour_bar_width(const FieldLegend& legend, const TextStyle& style) {
  const BarLayout layout = layout_of(legend, numbers_of(legend), style.cap_height);
  return static_cast<int>(std::ceil(layout.width()));
}

void draw_colour_bar(Image& image, const FieldLegend& legend, const TextStyle& style) {
  const NumberScale numbers = numbers_of(legend);
  const BarLayout layout = layout_of(legend, numbers, style.cap_height);
  const float line = 1.8F * style.cap_height;
  const float left = static_cast<float>(image.width()) - std::ceil(layout.width());
  const Eigen::Vector2i size(static_cast<int>(layout.bar_width), image.height() * 11 / 20);
  const Eigen::Vector2i corner(static_cast<int>(left), (image.height() - size.y()) / 2);
  fill_bar(image, legend.scale, corner, size, style.ink);

  const auto top = static_cast<float>(corner.y());
  const std::string unit = unit_text(legend, numbers);
  const float first_line = top - style.cap_height - (unit.empty() ? 0 : line);
  draw_text(image, legend.name, {left, first_line}, TextAlignment::left, style);
  draw_text(image, unit, {left, first_line + line}, TextAlignment::left, style);

  float note_line = top + static_cast<float>(size.y()) + 2 * style.cap_height;
  for (const std::string& note : note_lines(legend)) {
    draw_text(image, note, {left, note_line += line}, TextAlignment::left, style);
  }

  const float bar_right = left + static_cast<float>(size.x());
  for (const double tick : numbers.ticks) {
    const auto place = static_cast<float>(place_of(legend.scale, tick));
    const float y = top + 0.5F + (1 - place) * static_cast<float>(size.y() - 1);
    draw_line(image, {bar_right, y}, {bar_right + style.cap_height / 3, y}, 1, style.ink);
    draw_text(image, numbers.label(tick), {bar_right + 0.8F * layout.gap, y + style.cap_height / 2},
              TextAlignment::left, style);
  }
}

void draw_scale_bar(Image& image, const ScaleBar& bar) {
  constexpr Pixel kWhite = {255, 255, 255};
  const TextStyle style = label_style(image.height());
  const float margin = 1.6F * style.cap_height, tick = style.cap_height / 2;
  const auto length = static_cast<float>(bar.share * image.width());
  const Eigen::Vector2f from(margin, static_cast<float>(image.height()) - margin);
  const Eigen::Vector2f to = from + length * Eigen::Vector2f::UnitX();
  const Eigen::Vector2f up = tick * Eigen::Vector2f::UnitY();
  for (const auto& [width, ink] : {std::pair(5.0F, kWhite), std::pair(1.5F, style.ink)}) {
    draw_line(image, from, to, width, ink);
    for (const Eigen::Vector2f& end : {from, to}) draw_line(image, end - up, end + up, width, ink);
  }
  std::string text = length_text(bar.length);
  if (bar.lines) text += fmt::format("; lines {}, weft dashed", length_text(*bar.lines));
  draw_text(image, text, to + Eigen::Vector2f(style.cap_height, style.cap_height / 2),
            TextAlignment::left, style);
}

void draw_time(Image& image, double seconds, int decimals) {
  const TextStyle style = label_style(image.height());
  const float margin = 1.6F * style.cap_height;
  draw_text(image, fmt::format("t = {:.{}f} s", seconds, decimals),
            {margin, margin + style.cap_height}, TextAlignment::left, style);
}

}  // namespace pliant
