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

}  // namespace pliant
