#pragma once

#include <optional>
#include <string>

#include "pliant/render/colour_map.h"
#include "pliant/render/drawing.h"
#include "pliant/render/image.h"

namespace pliant {

/// What colours mean.
struct FieldLegend {
  std::string name;
  std::string unit;  ///< may be empty
  ColourScale scale;
  bool percentiles = false;  ///< the scale ends at percentiles, which the colour bar says
};

/// Sizes of the labels on a picture of a given height.
TextStyle label_style(int picture_height);

/// Pixels at the right edge that a colour bar with its labels needs.
int colour_bar_width(const FieldLegend& legend, const TextStyle& style);

/// Draws a bar of the scale's colours with round numbers, name and unit at the right edge.
void draw_colour_bar(Image& image, const FieldLegend& legend, const TextStyle& style);

/// A length as it appears in a picture.
struct ScaleBar {
  double length = 0;                 ///< m, a round number
  double share = 0;                  ///< of the width of the picture
  std::optional<double> lines = {};  ///< spacing of the lines on the cloth (m), where there are any
};

/// Draws the bar with its length, and what the lines on the cloth mean, into the lower left corner.
void draw_scale_bar(Image& image, const ScaleBar& bar);

/// Writes "t = ... s" into the upper left corner.
void draw_time(Image& image, double seconds, int decimals);

}  // namespace pliant
