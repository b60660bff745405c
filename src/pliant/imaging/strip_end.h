#pragma once

#include <Eigen/Core>

#include "pliant/imaging/photo.h"

namespace pliant {

/// Pixels that belong to something: 1, else 0.
using PixelMask = Eigen::Array<unsigned char, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Length of the shortest way through a mask from its first column to each of its pixels (pixels);
/// infinite outside, and where no way leads.
Photo ways_from_clamp(const PixelMask& inside);

/// The end of a strip that is farthest from its clamp.
struct StripEnd {
  Eigen::Vector2d place;      ///< pixel in the middle of it
  Eigen::Vector2d direction;  ///< in which the strip points there
};

/// @param inside     with pixels in its first column, or beyond
/// @param thickness  of the strip (pixels)
StripEnd free_end(const PixelMask& inside, double thickness);

/// Whether a strip goes on where it seems to end, fainter than the threshold that cut it off, as in
/// a shadow: ahead of its end, within 30 degrees of its direction, it is clearly nearer to the
/// strip's tone than on both sides of there.
/// @param contrast  to what is behind, towards the strip's tone
bool goes_on_faintly(const Photo& contrast, float threshold, const StripEnd& end, double thickness);

}  // namespace pliant
