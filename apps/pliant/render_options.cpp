#include "apps/pliant/render_options.h"

#include <initializer_list>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/nearest_name.h"
#include "pliant/base/number_text.h"

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

/// The value that a name stands for.
template <typename T>
T named(const std::string& option, const std::string& text,
        std::initializer_list<std::pair<const char*, T>> choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) {
    if (text == name) return value;
    names.emplace_back(name);
  }
  throw InputError({option}, quoted_value(text) + did_you_mean(text, names), list_of_names(names));
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

ViewDirection parse_view(const std::string& text) {
  return named<ViewDirection>("--view", text,
                              {{"front", ViewDirection::front},
                               {"side", ViewDirection::side},
                               {"top", ViewDirection::top},
                               {"three-quarter", ViewDirection::three_quarter}});
}

ColourMap parse_colour_map(const std::string& text) {
  return named<ColourMap>("--colour-map", text,
                          {{"viridis", ColourMap::viridis}, {"coolwarm", ColourMap::coolwarm}});
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

}  // namespace pliant
