#pragma once

#include <string_view>

#include <Eigen/Core>

#include "pliant/render/image.h"

namespace pliant {

/// How labels are written.
struct TextStyle {
  float cap_height = 11;  ///< of capitals and digits (pixels)
  Pixel ink = {40, 40, 40};
};

enum class TextAlignment { left, centre, right };

/// Writes a text on one line, with a light rim that keeps it readable on any picture.
/// @param base  where the base line begins, has its middle or ends, by the alignment: pixels from
///              the left and from the top
void draw_text(Image& image, std::string_view text, const Eigen::Vector2f& base,
               TextAlignment alignment = TextAlignment::left, const TextStyle& style = {});

/// Draws a straight line with round ends.
/// @param from, to  pixels from the left and from the top
void draw_line(Image& image, const Eigen::Vector2f& from, const Eigen::Vector2f& to, float width,
               const Pixel& ink);

}  // namespace pliant
