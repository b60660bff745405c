#pragma once

#include <array>

#include "pliant/material/strain/green_strain.h"

namespace pliant {

/// One of the eight points of a hexahedron with trilinear shape functions ([T] 4.2.6). Nodes as of
/// a VolumeMesh.
using TrilinearHexahedron = GreenStrain<8>;

/// A Gauss point of a hexahedron, two along each axis.
struct HexahedronPoint {
  TrilinearHexahedron::Rest rest;
  double size = 0;  ///< rest volume that it stands for (m^3)
};

/// @param rest_positions  of the nodes (m)
/// @throws AssertionError for a hexahedron that is turned inside out at a point
std::array<HexahedronPoint, 8> hexahedron_points(
    const TrilinearHexahedron::Positions& rest_positions);

}  // namespace pliant
