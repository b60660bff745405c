#pragma once

#include <string>
#include <vector>

#include "pliant/geometry/mesh_quality.h"
#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// How the owner of a volume mesh finds its nodes and elements again.
struct VolumeNumbering {
  std::string file = {};                ///< empty for a mesh that was made
  int first = 0;                        ///< number of the first node: 1 in files, 0 elsewhere
  std::vector<int> element_lines = {};  ///< line of each element; empty in a binary file
};

/// Everything that is wrong with a volume mesh, at most kMaxMeshProblems:
/// - no element at all; a node that is not there, or twice in an element; positions that are not
///   finite;
/// - an element that is turned inside out, at a point of a hexahedron, or flat (a volume of less
///   than 1e-6 of its longest edge cubed);
/// - a side of more than two elements; a node without elements, which would have no mass.
/// Where nodes are not there, only that is looked at.
std::vector<MeshProblem> find_volume_problems(const VolumeMesh& mesh,
                                              const VolumeNumbering& numbering = {});

/// @throws InputError with the first problem and the number of others
void require_good_volume_mesh(const VolumeMesh& mesh, const VolumeNumbering& numbering = {});

/// Elements that are not flat, but whose shape (`VolumeQuality`) is below 0.05: they make a system
/// stiff and its forces inexact. The worst first, at most kMaxMeshProblems.
/// @param mesh  without problems
std::vector<MeshProblem> find_slivers(const VolumeMesh& mesh,
                                      const VolumeNumbering& numbering = {});

/// How well the elements of a mesh are shaped.
struct VolumeQuality {
  double shortest_edge = 0, mean_edge = 0, longest_edge = 0;  ///< m, each edge as often as elements
                                                              ///< have it
  /// Of tetrahedra 12 (3 V)^(2/3) over the sum of the squares of the edges (Liu and Joe 1994), of
  /// hexahedra the least det of the unit edges at a corner: 1 for the best, 0 for a flat one.
  double least_shape = 1, mean_shape = 1;
};

/// @param mesh  without problems
VolumeQuality volume_quality(const VolumeMesh& mesh);

}  // namespace pliant
