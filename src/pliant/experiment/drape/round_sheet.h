#pragma once

#include <vector>

#include "pliant/experiment/drape/drape_setup.h"
#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// The part of a round specimen that hangs over a disc, with the triangles that hold it there.
struct RoundSheet {
  TriangleMesh mesh;      ///< flat, about the origin
  std::vector<int> held;  ///< vertices on the disc
  double flat_area = 0;   ///< of the whole specimen as the mesh's outline has it (m^2)
};

/// @param turn  of the mesh against the yarns (rad)
/// @throws InputError in a build without irregular meshes
RoundSheet round_sheet(const DrapeSetup& setup, double turn);

}  // namespace pliant
