#pragma once

#include <Eigen/Core>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// Pixels, in the order of DetectedTag.
using TagCorners = Eigen::Matrix<double, 2, 4>;

struct EdgeCorners {
  TagCorners corners;   ///< as near as can be told without knowing the lens
  TagCorners of_lines;  ///< where straight lines through the edges meet: less noise, but see below
};

/// Corners of a tag's black square by its edges. Across each edge, at places one pixel apart along
/// it, the edge lies where the mean of the gradient is, within three times the blur of the edge, or
/// less where the cells are narrow. A line goes through these places, or a parabola where it is
/// bent by more than chance, as lenses do; corners are where these meet.
/// @param picture  brightness in any unit
/// @param corners  within 2 pixels
/// @return what was given where the edges are not seen as expected
EdgeCorners corners_by_edges(const GreyPicture& picture, const TagCorners& corners);

/// The corners of a tag whose edges a known lens bends. Straight lines through them meet off its
/// corners, away from the middle of the picture by two thirds of the bend, so that whatever is
/// near seems larger: a rig calibrated with such corners states its lengths 1e-4 too small.
TagCorners corners_by_lens(const TagCorners& of_lines, const CameraModel& camera);

}  // namespace pliant
