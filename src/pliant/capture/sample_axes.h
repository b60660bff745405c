#pragma once

#include <Eigen/Core>

#include "pliant/capture/cord_line.h"
#include "pliant/capture/dic_file.h"
#include "pliant/geometry/pose.h"

namespace pliant {

/// Where a sample lies among measured points: coordinates of the sample (u, v, off its plane) from
/// those of the points.
struct SampleAxes {
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< rows: weft, warp, normal
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();    ///< of least u and v, in the points' (m)
  double off_plane = 0;  ///< root mean square of how far points at rest are off the plane (m)

  Eigen::Matrix3Xd of(const Eigen::Matrix3Xd& points) const {
    return axes * (points.colwise() - corner);
  }
  /// A motion of a body, and a cord.
  Pose of(const Pose& motion) const;
  CordLine of(CordLine line) const;
};

/// The plane through points at rest, weft and warp as the file tells them, and the corner that it
/// tells, or that centres the sample on the points.
/// @throws InputError where the points reach out of the sample by more than a tenth of it, or cover
///         less than a quarter of its width or height
SampleAxes sample_axes(const DicFile& dic, const Eigen::Matrix3Xd& rest);

}  // namespace pliant
