#pragma once

#include <optional>

#include <Eigen/Core>

#include "pliant/capture/pattern.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// Whether this build looks for chessboards: it takes OpenCV's calib3d.
bool can_find_chessboards();

/// The inner corners of a chessboard in a picture, in the order of Chessboard::corner. Where the
/// board does not show which side is up, either may be taken for it. A mirrored board looks like
/// another one that is turned: nothing tells.
/// @param picture  brightness, 0 to 1
/// @return pixels, one column a corner; nothing where not all of them are seen
std::optional<Eigen::Matrix2Xd> chessboard_corners(const GreyPicture& picture,
                                                   const Chessboard& board);

}  // namespace pliant
