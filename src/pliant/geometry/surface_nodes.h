#pragma once

#include <vector>

#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// The nodes on the surface of a mesh, rising.
std::vector<int> surface_nodes(const VolumeMesh& mesh);

}  // namespace pliant
