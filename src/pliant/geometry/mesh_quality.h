#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pliant/geometry/mesh_numbering.h"
#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// Something that makes a mesh unfit for simulation.
struct MeshProblem {
  std::string text;      ///< names the triangles or vertices
  std::string expected;  ///< what would be right
  int line = 0;          ///< of the first of them in the mesh's file; 0 where there is none
};

inline constexpr std::size_t kMaxMeshProblems = 100;

/// Everything that is wrong with a mesh, at most kMaxMeshProblems:
/// - a vertex that is not there, or twice in a triangle; two triangles with the same vertices;
/// - positions or rest coordinates that are not finite;
/// - a triangle without area, at rest or in space (less than 1e-6 of its longest edge squared), or
///   one that runs clockwise at rest;
/// - an edge with more than two triangles, or with two that run the same way along it;
/// - a vertex without triangles, which would have no mass.
/// Where vertices are not there, only that is looked at.
std::vector<MeshProblem> find_mesh_problems(const TriangleMesh& mesh,
                                            const MeshNumbering& numbering = {});

/// @throws InputError with the first problem and the number of others
void require_good_mesh(const TriangleMesh& mesh, const MeshNumbering& numbering = {});

/// How well the triangles of a mesh are shaped at rest.
struct MeshQuality {
  double shortest_edge = 0, mean_edge = 0, longest_edge = 0;  ///< of all triangles' sides (m)
  double smallest_angle = 0;                                  ///< rad
  int smallest_angle_triangle = 0;
  double largest_angle = 0;  ///< rad
  int largest_angle_triangle = 0;
  /// Longest edge over the height above it, in units of an equilateral triangle's.
  double largest_aspect_ratio = 0;
  int largest_aspect_ratio_triangle = 0;
};

/// @param mesh  without problems, with at least one triangle
MeshQuality mesh_quality(const TriangleMesh& mesh);

}  // namespace pliant
