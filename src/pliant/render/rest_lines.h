#pragma once

#include <Eigen/Core>

#include "pliant/render/ray_scene.h"

namespace pliant {

/// Lines along warp and, dashed, along weft, as if they were printed on the cloth.
struct RestLines {
  Eigen::Matrix2Xd rest_corners;  ///< m; corner k of triangle t is column 3 t + k
  double spacing = 0.1;           ///< at rest (m), > 0
};

/// A round spacing that gives a square cloth five to twelve lines each way.
/// @param rest_area  m^2, > 0
double usual_spacing(double rest_area);

/// Tells where on a mesh the lines are.
class RestLinePattern {
 public:
  /// @param positions  of the vertices, in the coordinates of the rays
  /// @param triangles  as many as `lines` has corners for
  RestLinePattern(const RestLines& lines, const Eigen::Matrix3Xf& positions,
                  const Eigen::Matrix3Xi& triangles);

  /// Whether a point is on a line.
  /// @param half_width  that a line has at least (m); where lines become so dense that it fills
  ///                    half of the cloth there are none
  bool covers(const RayHit& hit, float half_width) const;

 private:
  Eigen::Matrix2Xf corners_;  // rest coordinates of the triangles' corners, in spacings
  Eigen::Matrix2Xf slopes_;   // of these over the surface, by triangle (1/m)
};

}  // namespace pliant
