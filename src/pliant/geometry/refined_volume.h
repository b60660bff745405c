#pragma once

#include <vector>

#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// A mesh whose elements are cut into eight each, at the middles of their edges.
struct RefinedVolume {
  VolumeMesh mesh;  ///< with the labels, names and groups of the original
  /// Nodes of the original that each node lies in the middle of, rising: one, two of an edge, four
  /// of a face, eight of a hexahedron.
  std::vector<std::vector<int>> between;

  /// The nodes that lie between some of the original, rising.
  /// @param of_original  rising
  std::vector<int> nodes(const std::vector<int>& of_original) const;
};

RefinedVolume refined(const VolumeMesh& mesh);

}  // namespace pliant
