#pragma once

#include <string>
#include <vector>

#include "pliant/mechanics/solid_potentials.h"
#include "pliant/scene/scene.h"

namespace pliant {

/// A solid of a scene within its system.
struct SolidPiece {
  /// A material with the elements made of it, rising.
  struct Region {
    Material material;
    std::vector<int> elements;
    Eigen::VectorXd densities = {};  ///< of the material's samples (kg/m^3); empty: all are its own
  };

  std::string name;
  VolumeMesh mesh;           ///< at rest, in its own coordinates
  Eigen::Matrix3Xd placed;   ///< its nodes where they start (m)
  Eigen::Matrix3Xi surface;  ///< triangles of its surface, as nodes of the mesh
  std::vector<Region> regions;
  int first_point = 0;  ///< of the system: the mesh's node 0
  std::vector<ShownPotential> shown = {};

  int node_count() const { return mesh.node_count(); }
  /// Triangles of its surface as points of the system.
  Eigen::Matrix3Xi faces() const { return surface.array() + first_point; }
  /// Lengths of the edges of its surface at rest (m).
  struct EdgeLengths {
    double shortest = 0, mean = 0, longest = 0;
  };
  EdgeLengths edge_lengths() const;
  /// Masses of its nodes (kg).
  Eigen::VectorXd masses() const;
  /// What an element at each node resists being stretched with: the largest stiffness at rest times
  /// the mean edge (N/m).
  Eigen::VectorXd resistance_to_stretch() const;
};

/// Makes or reads the mesh of a solid, and sorts its elements by material.
/// @throws InputError for a mesh that is unfit for simulation, a material without mass where that
///         is needed, and one whose stiffness at rest is not positive
SolidPiece make_solid_piece(const SceneSolid& solid, const Scene& scene);

/// Adds the materials of a solid to the system of its scene.
void add_solid_materials(System& system, const Scene& scene, SolidPiece& piece);

}  // namespace pliant
