#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace pliant {

using TetrahedronList = Eigen::Matrix<int, 4, Eigen::Dynamic>;
using HexahedronList = Eigen::Matrix<int, 8, Eigen::Dynamic>;

/// A solid body at rest, cut into tetrahedra and hexahedra.
///
/// Elements are counted through both kinds, tetrahedra first. Node 3 of a tetrahedron lies on the
/// side of the triangle 0, 1, 2 to which its normal points. Nodes 0 to 3 of a hexahedron go round
/// one face, nodes 4 to 7 round the face across from it, which lies on the side to which the normal
/// of the first points: VTK's order, and that of gmsh, Medit and Abaqus.
struct VolumeMesh {
  Eigen::Matrix3Xd positions;  ///< m, one column a node
  TetrahedronList tetrahedra;  ///< nodes of each
  HexahedronList hexahedra;    ///< nodes of each
  std::vector<int> labels;     ///< of the region of each element; empty: all of one region, 0
  std::map<int, std::string> region_names;              ///< of labels, where they have any
  std::map<std::string, std::vector<int>> groups = {};  ///< of nodes, by name, rising

  int node_count() const { return static_cast<int>(positions.cols()); }
  int tetrahedron_count() const { return static_cast<int>(tetrahedra.cols()); }
  int hexahedron_count() const { return static_cast<int>(hexahedra.cols()); }
  int element_count() const { return tetrahedron_count() + hexahedron_count(); }
  int label_of(int element) const {
    return labels.empty() ? 0 : labels[static_cast<size_t>(element)];
  }
  /// The nodes of an element.
  std::vector<int> nodes_of(int element) const;
};

/// Volume of each element (m^3), signed where it is turned inside out.
Eigen::VectorXd element_volumes(const VolumeMesh& mesh);

/// Rest volume of each node (m^3): what its shape function has of the volumes around it.
Eigen::VectorXd node_volumes(const VolumeMesh& mesh);

/// The sides of elements that no other element has, as triangles whose normals point out of the
/// body; the four corners of a hexahedron's side make two. In the order of the elements.
struct BoundarySurface {
  Eigen::Matrix3Xi triangles;  ///< nodes of the volume mesh
  std::vector<int> elements;   ///< whose side each triangle is
};
BoundarySurface boundary_surface(const VolumeMesh& mesh);

/// The area that a uniform load on some triangles puts on each node: a third of each triangle's
/// (m^2).
Eigen::VectorXd node_areas(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles);

/// The diagonal of the box around a mesh (m).
double extent_of(const VolumeMesh& mesh);

/// The mean length of the edges of the surface (m), each counted once a triangle.
double mean_surface_edge(const VolumeMesh& mesh);

/// The nodes at which a coordinate has a value, up to rounding.
std::vector<int> nodes_at(const VolumeMesh& mesh, int axis, double value);

}  // namespace pliant
