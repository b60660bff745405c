#pragma once

#include "pliant/render/colour.h"

namespace pliant {

/// Colours for numbers, even to the eye and readable with the common colour vision deficiencies.
enum class ColourMap {
  viridis,   ///< dark blue over green to yellow, for values that run one way (Smith2015)
  coolwarm,  ///< blue over grey to red, for values on both sides of zero (Moreland2009)
};

/// @param position  from 0 (first colour) to 1 (last); clamped
Colour map_colour(ColourMap map, double position);

/// Which colour a value has.
struct ColourScale {
  ColourMap map = ColourMap::viridis;
  double low = 0;   ///< value of the first colour
  double high = 1;  ///< value of the last colour; not below `low`

  /// Values beyond the ends have the colours of the ends, NaN (no value) a light grey. A scale
  /// without extent has the middle colour.
  Colour colour(double value) const;
};

}  // namespace pliant
