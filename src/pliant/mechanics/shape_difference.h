#pragma once

#include <vector>

#include "pliant/geometry/hinges.h"
#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// How far apart two shapes of one sheet are.
struct ShapeDifference {
  double distance = 0;          ///< of the same points: root mean square over the rest area, m
  double largest_distance = 0;  ///< m
  /// Of the curvatures across edges: root mean square over the hinges' areas, 1/m. It does not feel
  /// where the sheet is, but how it is wrinkled; from a flat shape it is the other's own curvature.
  double curvature = 0;
};

/// Compares shapes of a sheet with each other.
class ShapeComparison {
 public:
  /// @param mesh  whose triangles and rest shape count, not its positions
  explicit ShapeComparison(const TriangleMesh& mesh);

  /// @param one, other  positions of the mesh's vertices, m
  ShapeDifference operator()(const Eigen::Matrix3Xd& one, const Eigen::Matrix3Xd& other) const;

 private:
  Eigen::VectorXd areas_;  // of the vertices
  std::vector<Hinge> hinges_;
};

}  // namespace pliant
