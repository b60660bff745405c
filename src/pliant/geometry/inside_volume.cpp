#include "pliant/geometry/inside_volume.h"

#include <algorithm>
#include <array>

#include <Eigen/LU>

#include "pliant/geometry/hexahedron_shape.h"

namespace pliant {
namespace {

constexpr double kOnTheSurface = 1e-6;  // of an element's size

bool is_in_tetrahedron(const std::array<Eigen::Vector3d, 4>& x, const Eigen::Vector3d& place) {
  Eigen::Matrix3d edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = x[static_cast<size_t>(i) + 1] - x[0];
  const Eigen::Vector3d shares = edges.partialPivLu().solve(place - x[0]);
  return shares.minCoeff() >= -kOnTheSurface && shares.sum() <= 1 + kOnTheSurface;
}

}  // namespace

bool is_inside(const VolumeMesh& mesh, const Eigen::Vector3d& place) {
  for (int e = 0; e < mesh.element_count(); ++e) {
    const std::vector<int> nodes = mesh.nodes_of(e);
    const auto within = [&](const std::array<int, 4>& corners) {
      std::array<Eigen::Vector3d, 4> x;
      for (size_t i = 0; i < 4; ++i) {
        x[i] = mesh.positions.col(nodes[static_cast<size_t>(corners[i])]);
      }
      return is_in_tetrahedron(x, place);
    };
    constexpr std::array kWhole{0, 1, 2, 3};
    if (nodes.size() == 4 ? within(kWhole) : std::ranges::any_of(kTetrahedraOfHexahedron, within))
      return true;
  }
  return false;
}

}  // namespace pliant
