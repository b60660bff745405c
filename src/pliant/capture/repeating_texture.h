#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/spline_picture.h"

namespace pliant {

/// That a texture looks like itself elsewhere.
struct TextureRepeat {
  double away = 0;         ///< median distance to the place that is most alike (pixels)
  double correlation = 0;  ///< median, of both places
};

/// Whether most of some squares of a picture are as much like another place within 60 pixels as
/// like themselves when they have moved: weaves and knits repeat, and are mistaken for their
/// neighbours.
/// @param places  middles of squares (pixels)
/// @return nothing of an irregular texture
std::optional<TextureRepeat> texture_repeat(const GreyPicture& picture,
                                            const Eigen::Matrix2Xd& places, int threads);

/// What speaks against a picture that repeats, for who took it.
std::vector<std::string> repeat_warnings(const GreyPicture& picture, const Eigen::Matrix2Xd& places,
                                         int threads);

}  // namespace pliant
