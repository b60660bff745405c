#pragma once

#include <Eigen/Core>

#include "pliant/capture/spline_picture.h"

namespace pliant {

/// Corners of a tag's black square by its edges. Across each edge, at places one pixel apart along
/// it, the edge lies where the mean of the gradient is, within three times the blur of the edge. A
/// line goes through these places, or a parabola where it is bent by more than chance, as lenses
/// do; corners are where these meet.
/// @param picture  brightness in any unit
/// @param corners  within 2 pixels, in the order of DetectedTag
/// @return pixels; what was given where the edges are not seen as expected
Eigen::Matrix<double, 2, 4> corners_by_edges(const GreyPicture& picture,
                                             const Eigen::Matrix<double, 2, 4>& corners);

}  // namespace pliant
