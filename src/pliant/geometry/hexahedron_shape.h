#pragma once

#include <array>

#include <Eigen/Core>

namespace pliant {

// The trilinear shape functions of a hexahedron at its eight Gauss points, two along each axis of
// the reference cube [-1, 1]^3, each of weight 1. Nodes as of a VolumeMesh.

/// Gradients of the nodes' shape functions in the reference cube.
const std::array<Eigen::Matrix<double, 8, 3>, 8>& hexahedron_gradients();

/// Values of the shape functions, of sum 1.
const std::array<Eigen::Matrix<double, 8, 1>, 8>& hexahedron_shares();

/// The volume that each point stands for (m^3), not above 0 where the element is turned inside out.
/// Their sum is the volume of the element exactly: the determinant is quadratic along each axis.
Eigen::Matrix<double, 8, 1> hexahedron_sizes(const Eigen::Matrix<double, 3, 8>& positions);

/// Nodes of six tetrahedra about the diagonal from node 0 to node 6 that make a hexahedron.
inline constexpr std::array<std::array<int, 4>, 6> kTetrahedraOfHexahedron{
    {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};

}  // namespace pliant
