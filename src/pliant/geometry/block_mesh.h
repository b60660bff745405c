#pragma once

#include <array>
#include <cstdint>

#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// A block from (0, 0, 0) to `size` (m) of counts[0] x counts[1] x counts[2] hexahedra. Nodes run
/// along x first, then y, then z.
VolumeMesh block_of_hexahedra(const Eigen::Vector3d& size, const std::array<int, 3>& counts);

/// The same with each cell cut into six tetrahedra around one of its diagonals, which turn over
/// from cell to cell, so that the block has no direction of its own.
VolumeMesh block_of_tetrahedra(const Eigen::Vector3d& size, const std::array<int, 3>& counts);

/// Moves the nodes inside a mesh at random, by up to a share of the shortest edge at each along
/// each axis: for tests that have to hold on any mesh.
/// @param share  less than a quarter, so that no element is turned inside out
VolumeMesh shaken_inside(VolumeMesh mesh, double share, std::uint64_t seed);

}  // namespace pliant
