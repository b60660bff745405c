#pragma once

#include <string>
#include <vector>

#include "pliant/capture/match_noise.h"
#include "pliant/capture/patch_tracker.h"

namespace pliant {

/// Why a picture that was followed last is to be distrusted, e.g. "is blurred"; empty: it is not.
///
/// Over-exposed, many pixels are as bright as the brightest; blurred, brightness changes less from
/// pixel to pixel than in the first picture. Both are looked at where patches were found, in some
/// of them.
/// @param now  the picture itself
std::string picture_doubt(const PatchTracker& tracker, const GreyPicture& now);

/// The same of the first picture, which is compared with no other: whether it is over-exposed.
std::string first_picture_doubt(const PatchTracker& tracker);

/// What speaks against the first picture when others were followed, a sentence each.
/// @param noise  of the tracker's matches
/// @param file   of the picture
std::vector<std::string> first_picture_warnings(const PatchTracker& tracker,
                                                const MatchNoise& noise, const std::string& file);

}  // namespace pliant
