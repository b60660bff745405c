#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pliant/geometry/triangle_mesh.h"
#include "pliant/material/component_density.h"
#include "pliant/mechanics/element_fields.h"
#include "pliant/mechanics/system.h"

namespace pliant {

/// A part of a cloth's potential that can be shown.
struct ShownPotential {
  std::shared_ptr<const Potential> potential;
  const ElementFields* fields = nullptr;  ///< the same object
};

/// What a cloth adds to a system.
struct Cloth {
  std::vector<ShownPotential> shown;
  std::vector<std::string> warnings;  ///< for the user, e.g. of bending that a mesh cannot show
};

/// Whether a material's measures are springs, which need a mesh cut from rectangles along weft and
/// warp. Springs of the second ring have a stiffness in N: their energy is per length.
bool needs_grid(const Material& material);

/// Rest area of each vertex, a third of its triangles' (m^2).
Eigen::VectorXd vertex_areas(const TriangleMesh& mesh);

/// Adds the elasticity, friction and damping of a material to a system, and its parameters to those
/// of the system.
///
/// The system may hold more than one cloth, and a cloth more than one material: each call covers
/// some triangles. A hinge between two materials belongs to that of its first triangle.
/// @param first_point  the system's point that is the mesh's vertex 0
/// @param triangles    those made of the material, increasing
/// @throws AssertionError when a component that is needed has no stiffness, and for springs on a
///         mesh that is no grid
Cloth add_cloth(System& system, const TriangleMesh& mesh, int first_point, const Material& material,
                const std::vector<int>& triangles, const DensityOptions& options);

/// The same for a mesh of one material.
Cloth add_cloth(System& system, const TriangleMesh& mesh, const Material& material,
                const DensityOptions& options);

}  // namespace pliant
