#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// All points x with normal . x = offset.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  ///< of length 1
  double offset = 0;                                  ///< m

  double distance(const Eigen::Vector3d& point) const { return normal.dot(point) - offset; }
};

/// What a plane leaves of a mesh on the side that its normal does not point to.
struct PlaneCut {
  /// A vertex on the way between two of the mesh.
  struct Vertex {
    int from = 0, to = 0;
    double share = 0;  ///< of the way
  };
  std::vector<Vertex> vertices;
  Eigen::Matrix3Xi triangles;  ///< those of the surface, then those of the section

  /// Numbers at the vertices of the mesh (a row each way, a column a vertex) as the cut has them.
  Eigen::MatrixXd values(const Eigen::MatrixXd& of_mesh) const;
};

/// Cuts a surface and the tetrahedra within it. The section faces the side that is cut away, and
/// shares no vertices with the surface.
/// @param positions  of the vertices, one column each
PlaneCut cut_by_plane(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& surface,
                      const Eigen::Matrix4Xi& tetrahedra, const Plane& plane);

/// The elements of a mesh as tetrahedra: six for each hexahedron, about a diagonal.
Eigen::Matrix4Xi tetrahedra_of(const VolumeMesh& mesh);

}  // namespace pliant
