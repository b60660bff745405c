#include "pliant/geometry/block_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/base/assert.h"
#include "pliant/base/random.h"

namespace pliant {
namespace {

int node_number(const std::array<int, 3>& counts, int i, int j, int k) {
  return (k * (counts[1] + 1) + j) * (counts[0] + 1) + i;
}

Eigen::Matrix3Xd block_nodes(const Eigen::Vector3d& size, const std::array<int, 3>& counts) {
  Eigen::Matrix3Xd positions(3, (counts[0] + 1) * (counts[1] + 1) * (counts[2] + 1));
  for (int k = 0; k <= counts[2]; ++k) {
    for (int j = 0; j <= counts[1]; ++j) {
      for (int i = 0; i <= counts[0]; ++i) {
        positions.col(node_number(counts, i, j, k)) << size.x() * i / counts[0],
            size.y() * j / counts[1], size.z() * k / counts[2];
      }
    }
  }
  return positions;
}

// The nodes of a cell by the bits of their number: 1 along x, 2 along y, 4 along z.
std::array<int, 8> cell_nodes(const std::array<int, 3>& counts, int i, int j, int k) {
  std::array<int, 8> nodes{};
  for (int n = 0; n < 8; ++n) {
    nodes[static_cast<size_t>(n)] =
        node_number(counts, i + (n & 1), j + (n >> 1 & 1), k + (n >> 2));
  }
  return nodes;
}

template <class Add>
void for_each_cell(const std::array<int, 3>& counts, const Add& add) {
  for (int k = 0; k < counts[2]; ++k) {
    for (int j = 0; j < counts[1]; ++j) {
      for (int i = 0; i < counts[0]; ++i) add(i, j, k);
    }
  }
}

// The ways from a corner of a cell to the one across, along each axis once (Kuhn).
constexpr int kWays[6][2] = {{1, 2}, {2, 4}, {4, 1}, {2, 1}, {4, 2}, {1, 4}};

}  // namespace

VolumeMesh block_of_hexahedra(const Eigen::Vector3d& size, const std::array<int, 3>& counts) {
  PLIANT_ASSERT(std::ranges::min(counts) > 0 && size.minCoeff() > 0, "a block has cells");
  VolumeMesh mesh;
  mesh.positions = block_nodes(size, counts);
  mesh.hexahedra.resize(8, counts[0] * counts[1] * counts[2]);
  Eigen::Index next = 0;
  for_each_cell(counts, [&](int i, int j, int k) {
    const auto n = cell_nodes(counts, i, j, k);
    mesh.hexahedra.col(next++) << n[0], n[1], n[3], n[2], n[4], n[5], n[7], n[6];
  });
  return mesh;
}

// Cells are mirrored along each axis by whether their number there is odd: neighbours then cut the
// side between them alike.
VolumeMesh block_of_tetrahedra(const Eigen::Vector3d& size, const std::array<int, 3>& counts) {
  PLIANT_ASSERT(std::ranges::min(counts) > 0 && size.minCoeff() > 0, "a block has cells");
  VolumeMesh mesh;
  mesh.positions = block_nodes(size, counts);
  mesh.tetrahedra.resize(4, 6 * counts[0] * counts[1] * counts[2]);
  Eigen::Index next = 0;
  for_each_cell(counts, [&](int i, int j, int k) {
    const auto n = cell_nodes(counts, i, j, k);
    const int mirrored = (i & 1) | (j & 1) << 1 | (k & 1) << 2;
    const auto node = [&](int corner) { return n[static_cast<size_t>(corner ^ mirrored)]; };
    const bool reversed = ((i + j + k) & 1) != 0;
    for (const auto& [first, second] : kWays) {
      const bool left =
          (first == 1 && second == 2) || (first == 2 && second == 4) || (first == 4 && second == 1);
      int b = node(first), c = node(first | second);
      if (left == reversed) std::swap(b, c);
      mesh.tetrahedra.col(next++) << node(0), b, c, node(7);
    }
  });
  return mesh;
}

VolumeMesh shaken_inside(VolumeMesh mesh, double share, std::uint64_t seed) {
  const int nodes = mesh.node_count();
  Eigen::VectorXd shortest = Eigen::VectorXd::Constant(nodes, INFINITY);
  for (int e = 0; e < mesh.element_count(); ++e) {
    const std::vector<int> own = mesh.nodes_of(e);
    for (const int a : own) {
      for (const int b : own) {
        if (a == b) continue;
        const double length = (mesh.positions.col(a) - mesh.positions.col(b)).norm();
        shortest(a) = std::min(shortest(a), length);
      }
    }
  }
  const BoundarySurface surface = boundary_surface(mesh);
  for (const int node : surface.triangles.reshaped()) shortest(node) = 0;
  RandomStream random(seed);
  for (int i = 0; i < nodes; ++i) {
    for (int a = 0; a < 3; ++a) mesh.positions(a, i) += share * shortest(i) * random.uniform(-1, 1);
  }
  return mesh;
}

}  // namespace pliant
