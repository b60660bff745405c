#pragma once

#include <Eigen/Core>

#include "pliant/base/errors.h"
#include "pliant/imaging/photo.h"

namespace pliant {

/// Pixels that a draped specimen covers, 1 or 0, and how far they were brought together.
struct DrapeMask {
  Eigen::Array<unsigned char, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> inside;
  double pixel = 1;  ///< side of one of its pixels, in pixels of the picture, >= 1
};

/// Finds the one large thing that stands out by its colour from what is behind it, whose light and
/// colour may change slowly across the picture. What touches the border is no specimen, holes are
/// filled, and fibres that stick out are taken off.
/// @param where  of the picture, for messages
/// @throws InputError where nothing stands out, or what does leaves the picture
DrapeMask find_drape(const ColourPhoto& photo, const Location& where);

/// What of a picture stands out from its background, and what of that could be the specimen, as
/// `find_drape` sees it.
SeenPixels drape_seen(const ColourPhoto& photo);

}  // namespace pliant
