#pragma once

#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// Whether a place lies in an element of a mesh, or on its surface.
bool is_inside(const VolumeMesh& mesh, const Eigen::Vector3d& place);

}  // namespace pliant
