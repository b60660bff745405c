#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// A straight piece of a drawn line.
struct Segment {
  Eigen::Vector2f from;
  Eigen::Vector2f to;
};

/// The lines of a text in a single-stroke font made for labels: ASCII; any other character is an
/// empty box. Origin at the left end of the base line, y upwards; capitals and digits are
/// `cap_height` high, descenders reach 0.3 of it below the base line. Digits are equally wide.
std::vector<Segment> text_segments(std::string_view text, float cap_height);

/// From the left edge of the first character to the right edge of the last.
float text_width(std::string_view text, float cap_height);

}  // namespace pliant
