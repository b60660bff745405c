#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// Where the vertices of a mesh are in a frame.
struct SeenVertices {
  Eigen::Matrix3Xd positions;  ///< m; NaN of those that are not seen
  Eigen::VectorXd leverages;   ///< as of MovedPlace; 1 of those that are not seen
};

/// Puts the vertices of a mesh where the points around them say, and keeps by how much points miss
/// that.
class VertexPlaces {
 public:
  /// @param spacing   of the points (m)
  /// @param patch     side of the squares whose means they are (m), or 0
  /// @param in_space  whether cloth may bend: a wider reach tells then how
  VertexPlaces(double spacing, double patch, bool in_space)
      : spacing_(spacing), patch_(patch), in_space_(in_space) {}

  /// @param rest, moved  of the points that are seen (m)
  /// @param patches      of each of them, see LocalMotion::bend
  /// @param at_rest      displacements are counted from this frame, which misses nothing
  SeenVertices of(const TriangleMesh& mesh, const Eigen::Matrix2Xd& rest,
                  const Eigen::Matrix3Xd& moved, const Eigen::VectorXd& patches, bool at_rest);

  /// By which a coordinate of a point misses the motion of those around it (m).
  double point_noise() const;
  /// The same of a vertex; nothing where points miss by nothing.
  std::optional<double> noise() const;

 private:
  double spacing_, patch_;
  bool in_space_;
  std::vector<double> residuals_;  // mean squares, of each vertex and frame
  double leverage_ = 0;            // their sum
};

/// Standard deviations of a mesh's vertices by those of measured points: those of the nearest
/// point, since the errors of points so near are alike; beyond the points they grow.
/// @param places     2 x points, rest coordinates (m)
/// @param of_points  3 x points (m)
/// @param leverages  of the vertices, as of MovedPlace
/// @param reach      of the nearest point (m); where none is, the largest deviations
/// @return 3 x vertices (m)
Eigen::Matrix3Xd vertex_deviations(const TriangleMesh& mesh, const Eigen::Matrix2Xd& places,
                                   const Eigen::Matrix3Xd& of_points,
                                   const Eigen::VectorXd& leverages, double reach);

}  // namespace pliant
