#pragma once

#include <Eigen/Core>

namespace pliant {

/// Points of a surface, laid flat so that distances between neighbours are what they are along the
/// surface, as near as can be [Sorkine2007].
struct UnrolledSheet {
  Eigen::Matrix2Xd places;  ///< m, one column a point
  /// Root mean square by which distances of neighbours differ from those along the surface, a share
  /// of them: 0 of a surface that can be laid flat, as a bent one, and not of a wrinkled one.
  double stretch = 0;
};

/// Pieces that nothing connects with the largest one go as the point of it does that is nearest.
/// @param points  3 x points, the surface seen along the third axis, over which it does not hang
/// (m)
/// @param reach   of neighbours in the first two coordinates, some two distances of points (m)
UnrolledSheet unrolled(const Eigen::Matrix3Xd& points, double reach);

}  // namespace pliant
