#pragma once

#include <memory>
#include <vector>

#include "pliant/geometry/block_mesh.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/mechanics/solid_potentials.h"
#include "pliant/solver/static_solver.h"

#include "support/solid_laws.h"

namespace pliant::test {

enum class Cells { tetrahedra, hexahedra };

inline VolumeMesh block_of(Cells cells, const Eigen::Vector3d& size,
                           const std::array<int, 3>& counts) {
  return cells == Cells::tetrahedra ? block_of_tetrahedra(size, counts)
                                    : block_of_hexahedra(size, counts);
}

/// A solid as a system. `system` is not finished: a test first adds its own supports and forces.
struct SolidSystem {
  VolumeMesh mesh;
  std::unique_ptr<System> system;
  Solid solid;

  void hold(const std::vector<int>& nodes) {
    for (const int node : nodes) system->coordinates().prescribe(node);
  }
  void hold(const std::vector<int>& nodes, int axis) {
    for (const int node : nodes) system->coordinates().prescribe_axis(node, axis);
  }
  void load(const Eigen::Matrix3Xd& forces) { system->add(std::make_shared<PointForces>(forces)); }
};

/// @param density  kg/m^3
/// @param start    of the nodes, where that is not the rest shape
inline SolidSystem solid_system(const VolumeMesh& mesh, const SolidLaw& law, double density = 0,
                                const Eigen::Matrix3Xd& start = {}) {
  SolidSystem result{mesh, nullptr, {}};
  result.system = std::make_unique<System>(start.size() > 0 ? start : mesh.positions,
                                           density * node_volumes(mesh));
  result.solid = add_solid(*result.system, mesh, law);
  return result;
}

/// A heterogeneous rubber along x: samples 0.1 m apart, as stiff as their factors.
inline Material rubber_along_x(const std::vector<double>& factors) {
  Material material = neo_hookean_solid(1e4, 5e4);
  for (std::size_t k = 0; k < factors.size(); ++k) {
    material.samples.at.push_back(
        {{0.05 + 0.1 * static_cast<double>(k), 0.05, 0.05},
         neo_hookean_solid(1e4 * factors[k], 5e4 * factors[k]).components});
  }
  material.samples.width = 0.1;
  return material;
}

/// The equilibrium of a finished system, from where it starts.
inline NewtonSummary settle(const System& system, State& state, double tolerance) {
  return StaticSolver(system, {.tolerance = tolerance}).find_equilibrium(state);
}

/// The nodes of the surface, rising.
inline std::vector<int> surface_nodes(const VolumeMesh& mesh) {
  std::vector<bool> on(static_cast<size_t>(mesh.node_count()), false);
  const BoundarySurface surface = boundary_surface(mesh);
  for (const int node : surface.triangles.reshaped()) {
    on[static_cast<size_t>(node)] = true;
  }
  std::vector<int> nodes;
  for (int i = 0; i < mesh.node_count(); ++i) {
    if (on[static_cast<size_t>(i)]) nodes.push_back(i);
  }
  return nodes;
}

}  // namespace pliant::test
