#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/pose.h"

namespace pliant {

/// Corners of a label that lies in a plane, and where a picture shows them.
struct LabelSighting {
  Eigen::Matrix<double, 2, 4> rest;  ///< in the plane, as its body was at rest (m)
  Eigen::Matrix<double, 2, 4> seen;  ///< pixels
  int body = 0;                      ///< that carries it; body 0 has stayed where it was
};

/// How a picture shows a plane and the rigid bodies that move in it.
struct PlaneFit {
  Eigen::Matrix3d to_picture;  ///< homography, from m to pixels
  std::vector<Pose> bodies;    ///< their motions since they were at rest, in the plane
  double miss = 0;             ///< root mean square of the residuals (pixels)
};

/// The homography and the motions that least squares give. Each body but the first adds three
/// unknowns to the eight of the homography, and each label eight equations.
/// @param sightings  at least one of each body
/// @param bodies     how many
PlaneFit fit_plane(const std::vector<LabelSighting>& sightings, int bodies);

}  // namespace pliant
