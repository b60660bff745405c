#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pliant/geometry/volume_mesh.h"
#include "pliant/material/component_density.h"
#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/mechanics/system.h"

namespace pliant {

/// The law of a solid's material as its elements take it.
struct SolidLaw {
  std::shared_ptr<const ParametricDensity> of_points;  ///< of the six strains of a GreenStrain
  /// Of one strain, V / V0 - 1, of which a hexahedron and the surroundings of a node of tetrahedra
  /// have one: what a material of nearly constant volume has against changes of it. The law of
  /// points then leaves them free. Null: the law of points has all.
  std::shared_ptr<const ParametricDensity> of_volume;
  std::vector<std::string> parameters;     ///< names, of points first; empty: not among a system's
  std::vector<std::string> point_fields;   ///< names of the strains and histories of points
  std::vector<std::string> volume_fields;  ///< the same of volumes
  MaterialSamples samples = {};  ///< that the law blends, by their weights at each place at rest
};

/// The law of a material of kind solid. What its component J has, a law of the volume alone, acts
/// on the volumes of elements and nodes; all else acts on points.
SolidLaw solid_law(const Material& material, const DensityOptions& options = {});

/// Stiffness of a law at rest: the tangent dS/dE on the six strains, volumes included (Pa); of a
/// heterogeneous one the mean of its samples.
Eigen::Matrix<double, 6, 6> stiffness_at_rest(const SolidLaw& law);

/// What a solid adds to a system.
struct Solid {
  std::vector<ShownPotential> shown;
};

/// Adds the elasticity, friction and damping of a material to a system, and its parameters to those
/// of the system. A solid may have more than one material: each call covers some of its elements.
/// @param first_point  the system's point that is the mesh's node 0
/// @param elements     those made of the material, rising
/// @throws AssertionError for an element that is turned inside out at rest
Solid add_solid(System& system, const VolumeMesh& mesh, int first_point, const SolidLaw& law,
                const std::vector<int>& elements);

/// The same for a mesh of one material.
Solid add_solid(System& system, const VolumeMesh& mesh, const SolidLaw& law);

/// Forces of a load per area that keeps its direction, on triangles of a surface (N, one column a
/// node).
/// @param traction  Pa
Eigen::Matrix3Xd traction_forces(const Eigen::Matrix3Xd& positions,
                                 const Eigen::Matrix3Xi& triangles,
                                 const Eigen::Vector3d& traction);

}  // namespace pliant
