#pragma once

#include <optional>

#include <Eigen/Core>

#include "pliant/base/errors.h"
#include "pliant/imaging/photo.h"
#include "pliant/imaging/strip_end.h"

namespace pliant {

/// Whether a strip is brighter or darker than what is behind it.
enum class StripTone { automatic, brighter, darker };

/// How a strip is to be looked for in a picture whose left border is the edge of its clamp.
struct StripSearch {
  StripTone tone = StripTone::automatic;
  std::optional<double> clamp_row;    ///< at which it leaves the clamp, to tell it from others
  std::string clamp_border = "left";  ///< names for messages: of the border at the clamp,
  std::string far_border = "right";   ///< and of the one opposite
};

/// The pixels of a strip.
struct StripMask {
  Photo contrast;  ///< by how much each pixel differs from what is behind, towards the strip's tone
  PixelMask inside;
  float threshold = 0;   ///< contrast from which on a pixel counts
  double thickness = 0;  ///< of the strip, a mean over its length (pixels)
  StripTone tone = StripTone::brighter;
  int gaps = 0;  ///< across which pieces of it were joined
};

/// Finds the one long, thin thing that begins at the left border. What is interrupted, as by
/// something in front of it, is joined across gaps of up to ten times its thickness, where the next
/// piece goes on in its direction.
/// @param where  of the picture, for messages
/// @throws InputError where nothing stands out, nothing reaches the clamp, several things of the
///         kind are seen, the strip leaves the picture, or goes on beyond its end
StripMask find_strip(const Photo& photo, const StripSearch& search, const Location& where);

/// What of a picture stands out from its background, and what of that could be strips, as
/// `find_strip` sees it.
SeenPixels things_seen(const Photo& photo, StripTone tone);

}  // namespace pliant
