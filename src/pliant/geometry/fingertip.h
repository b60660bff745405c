#pragma once

#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// A body like the last phalanx of a finger: an elliptic cylinder along x from x = 0 that ends in
/// half an ellipsoid, with the nail's side up (+z) and the pad down.
struct Fingertip {
  double length = 0;  ///< along x (m), more than half the width
  double width = 0;   ///< along y (m)
  double height = 0;  ///< along z (m)
  double edge = 0;    ///< length that edges of its tetrahedra aim at (m)
};

/// Tetrahedra of a fingertip in the regions `tissue`, `bone` and `skin`: the bone lies nearer to
/// the nail, the skin is the outermost tenth of the height. Elements are told by their centres, so
/// that the borders of regions are as fine as the mesh. Its node groups are `bone`, `nail` (a patch
/// of the upper side) and `base` (x = 0).
/// @throws InputError where the program was built without CGAL
VolumeMesh make_fingertip(const Fingertip& shape);

}  // namespace pliant
