#include "apps/pliant/render_options.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"

namespace pliant {
namespace {

constexpr long kSmallestSide = 16, kLargestSide = 14000;  // a square of it is within kMostPixels

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (size_t end = 0; end != std::string_view::npos;) {
    end = text.find(separator);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end != std::string_view::npos) text.remove_prefix(end + 1);
  }
  return parts;
}

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& expected) {
  throw InputError({option}, quoted_value(text) + " cannot be used", expected);
}

/// First and last number and step of "FIRST:LAST:STEP".
struct FrameRange {
  long first = 0;
  long last = std::numeric_limits<long>::max();
  long step = 1;
};

std::optional<FrameRange> parse_frame_range(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() > 3) return std::nullopt;
  FrameRange range;
  const auto read = [&](size_t part, long& value) {
    if (part >= parts.size() || parts[part].empty()) return true;
    const std::optional<long> number = parse_integer(parts[part]);
    value = number.value_or(-1);
    return value >= 0;
  };
  if (!read(0, range.first) || !read(1, range.last) || !read(2, range.step)) return std::nullopt;
  if (parts.size() == 1) range.last = range.first;
  if (range.step == 0) return std::nullopt;
  return range;
}

}  // namespace

PictureSize parse_picture_size(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, 'x');
  const auto side = [](std::string_view part) {
    const long pixels = parse_integer(part).value_or(0);
    return pixels >= kSmallestSide && pixels <= kLargestSide ? static_cast<int>(pixels) : 0;
  };
  const PictureSize size =
      parts.size() == 2 ? PictureSize{side(parts[0]), side(parts[1])} : PictureSize{0, 0};
  if (size.width == 0 || size.height == 0) {
    refuse("--size", text,
           fmt::format("width and height of {} to {} pixels, as in 800x600", kSmallestSide,
                       kLargestSide));
  }
  return size;
}

Colour parse_colour_option(const std::string& option, const std::string& text) {
  const std::optional<Colour> colour = parse_colour(text);
  if (!colour) refuse(option, text, "red, green and blue as in #7fa3cf");
  return *colour;
}

ColourMap parse_colour_map(const std::string& text) {
  if (text == "viridis") return ColourMap::viridis;
  if (text == "coolwarm") return ColourMap::coolwarm;
  const std::vector<std::string> names{"viridis", "coolwarm"};
  throw InputError({"--colour-map"}, quoted_value(text) + did_you_mean(text, names),
                   list_of_names(names));
}

Eigen::Vector3d parse_point(const std::string& option, const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ',');
  Eigen::Vector3d point;
  for (size_t i = 0; i < 3; ++i) {
    const std::optional<double> number = parts.size() == 3 ? parse_number(parts[i]) : std::nullopt;
    if (!number) refuse(option, text, "three coordinates in metres, as in 1,-2.5,1.2");
    point[static_cast<Eigen::Index>(i)] = *number;
  }
  return point;
}

std::pair<double, double> parse_value_range(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() == 2) {
    const std::optional<double> low = parse_number(parts[0]), high = parse_number(parts[1]);
    if (low && high && *low < *high) return {*low, *high};
  }
  refuse("--range", text, "values of the first and of the last colour, as in 0:0.2");
}

AxisPlane parse_cut(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, '=');
  constexpr std::string_view kAxes = "xyz";
  const std::size_t axis = parts.front().size() == 1 ? kAxes.find(parts.front()) : kAxes.npos;
  if (parts.size() == 2 && axis != kAxes.npos) {
    try {
      const auto metres = parse_number(parts[1]);
      return {static_cast<int>(axis),
              metres ? *metres : parse_quantity(parts[1], Dimension::length)};
    } catch (const QuantityError&) {
    }
  }
  refuse("--cut", text, "an axis and a length, as in x=0.02 or 'z = 5 mm'");
}

std::vector<SimulationFrame> select_frames(const std::vector<SimulationFrame>& frames,
                                           const std::string& text) {
  if (text.empty()) return frames;
  const std::optional<FrameRange> range = parse_frame_range(text);
  if (!range) refuse("--frames", text, "FIRST:LAST:STEP, as in 0:100:5, 40: or ::10");
  std::vector<SimulationFrame> selected;
  long passed = 0;
  for (const SimulationFrame& frame : frames) {
    if (frame.index < range->first || frame.index > range->last) continue;
    if (passed++ % range->step == 0) selected.push_back(frame);
  }
  if (selected.empty()) {
    throw InputError(
        {"--frames"}, quoted_value(text) + " selects no frame",
        fmt::format("numbers from {} to {}", frames.front().index, frames.back().index));
  }
  return selected;
}

double parse_line_spacing(const std::string& text) {
  try {
    const double spacing = parse_quantity(text, Dimension::length);
    if (spacing > 0) return spacing;
  } catch (const QuantityError&) {
  }
  refuse("--lines", text, "a length above 0, as in '50 mm', auto or none");
}

std::string FilmRate::text() const {
  std::string text = format_number(pictures, 3) + " a second";
  if (std::abs(speed - 1) > 0.01) {
    text += fmt::format(", {} times as fast as in reality", format_number(speed, 2));
  }
  return text;
}

FilmRate film_rate(const std::vector<SimulationFrame>& frames, double rate) {
  std::vector<double> spacings;
  for (size_t i = 1; i < frames.size(); ++i) {
    spacings.push_back(frames[i].time - frames[i - 1].time);
  }
  if (spacings.empty()) return {rate > 0 ? rate : 1};
  const auto middle = spacings.begin() + std::ssize(spacings) / 2;
  std::nth_element(spacings.begin(), middle, spacings.end());
  const double pictures = rate > 0 ? rate : std::clamp(1 / *middle, 1.0, 60.0);
  return {pictures, pictures * *middle};
}

}  // namespace pliant
