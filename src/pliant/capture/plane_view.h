#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/lens.h"
#include "pliant/geometry/pose.h"

namespace pliant {

/// How a picture shows the plane of a flat sample, and what it says of the clips in it.
struct PlaneView {
  Lens lens;
  Eigen::Matrix3d to_plane = Eigen::Matrix3d::Identity();  ///< homography from pixels that the lens
                                                           ///< has not bent to m
  /// How each clip has moved in the plane since the first picture; nothing of clips that show no
  /// labels.
  std::vector<std::optional<Pose>> clips;
  /// By what share of its distance a clip has come nearer to the camera against the first clip with
  /// labels, since the first picture; of several the largest.
  double nearer = 0;
  double miss = 0;  ///< root mean square by which corners of labels miss the view (pixels)

  /// @param pixels  2 x places of the picture (column, row)
  /// @return m
  Eigen::Matrix2Xd on_plane(const Eigen::Matrix2Xd& pixels) const;
  /// @param places  2 x places of the plane (m)
  /// @return pixels
  Eigen::Matrix2Xd in_picture(const Eigen::Matrix2Xd& places) const;
};

/// The view of a camera that stands straight in front of the plane.
/// @param scale  length of a pixel (m)
PlaneView straight_view(double scale);

}  // namespace pliant
