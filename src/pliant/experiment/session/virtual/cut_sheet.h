#pragma once

#include <Eigen/Core>

#include "pliant/experiment/session/virtual/options.h"
#include "pliant/geometry/pose.h"
#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// A rectangle that was cut from a cloth, not always along its yarns.
struct CutSheet {
  Eigen::Matrix2Xd places;  ///< of the vertices in the rectangle [0, width] x [0, height] (m)
  Pose placed;              ///< of the rectangle in the rest plane, a turn about z
  TriangleMesh rest;        ///< in the axes of weft and warp, from 0 on
};

/// The sheet of a session on its mesh. Edges of an irregular mesh run along those of clips, so that
/// the vertices in a clip hold exactly the cloth that it clamps. A build that can make no irregular
/// ones takes a grid of about that edge.
CutSheet cut_sheet(const VirtualSession& options);

}  // namespace pliant
