#pragma once

#include <array>

#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/hinges.h"
#include "pliant/geometry/triangle_mesh.h"
#include "pliant/geometry/volume_mesh.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/material/strain/hexahedron_dilatation.h"
#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/material/strain/soft_constraint_membrane.h"
#include "pliant/material/strain/spring.h"
#include "pliant/material/strain/stvk_membrane.h"
#include "pliant/material/strain/trilinear_hexahedron.h"
#include "pliant/mechanics/stencils.h"

namespace pliant::test {

/// A small block whose nodes inside stand beside their places.
/// @param edge  of its cells (m)
inline VolumeMesh shaken_block(bool of_tetrahedra, double edge) {
  const Eigen::Vector3d size(3 * edge, 2 * edge, 2 * edge);
  return shaken_inside(
      of_tetrahedra ? block_of_tetrahedra(size, {3, 2, 2}) : block_of_hexahedra(size, {3, 2, 2}),
      0.2, 3);
}

// The stencils of every measure on a mesh.

template <class Membrane>
Stencils<Membrane> triangles_of(const TriangleMesh& mesh) {
  Stencils<Membrane> stencils;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const MembraneRest rest = membrane_rest(mesh.rest_triangle(t));
    const Eigen::Vector3i nodes = mesh.triangles.col(t);
    stencils.add({nodes(0), nodes(1), nodes(2)}, rest, rest.area);
  }
  return stencils;
}

inline Stencils<Spring> springs_of(const TriangleMesh& mesh) {
  Stencils<Spring> stencils;
  for (const Hinge& hinge : find_hinges(mesh)) {
    const double length = hinge.rest_edge.norm();
    stencils.add({hinge.vertices[0], hinge.vertices[1]}, {length}, length * length);
  }
  return stencils;
}

inline Stencils<DiscreteShells> hinges_of(const TriangleMesh& mesh) {
  Stencils<DiscreteShells> stencils;
  for (const Hinge& hinge : find_hinges(mesh)) {
    stencils.add(hinge.vertices, {0, hinge.height, 0}, hinge.area);
  }
  return stencils;
}

inline Stencils<LinearTetrahedron> tetrahedra_of(const VolumeMesh& mesh) {
  Stencils<LinearTetrahedron> stencils;
  for (const auto& nodes : mesh.tetrahedra.colwise()) {
    const LinearTetrahedron::Positions x = mesh.positions(Eigen::all, nodes);
    stencils.add({nodes(0), nodes(1), nodes(2), nodes(3)}, tetrahedron_rest(x),
                 tetrahedron_volume(x));
  }
  return stencils;
}

inline std::array<int, 8> eight(const Eigen::Ref<const Eigen::VectorXi>& nodes) {
  return {nodes(0), nodes(1), nodes(2), nodes(3), nodes(4), nodes(5), nodes(6), nodes(7)};
}

inline Stencils<TrilinearHexahedron> hexahedron_points_of(const VolumeMesh& mesh) {
  Stencils<TrilinearHexahedron> stencils;
  for (const auto& nodes : mesh.hexahedra.colwise()) {
    for (const HexahedronPoint& point : hexahedron_points(mesh.positions(Eigen::all, nodes))) {
      stencils.add(eight(nodes), point.rest, point.size);
    }
  }
  return stencils;
}

inline Stencils<HexahedronDilatation> dilatations_of(const VolumeMesh& mesh) {
  Stencils<HexahedronDilatation> stencils;
  const Eigen::VectorXd volumes = element_volumes(mesh);
  for (int e = 0; e < mesh.hexahedron_count(); ++e) {
    stencils.add(eight(mesh.hexahedra.col(e)), {volumes(e)}, volumes(e));
  }
  return stencils;
}

}  // namespace pliant::test
