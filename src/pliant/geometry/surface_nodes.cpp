#include "pliant/geometry/surface_nodes.h"

#include <algorithm>

namespace pliant {

std::vector<int> surface_nodes(const VolumeMesh& mesh) {
  const Eigen::Matrix3Xi triangles = boundary_surface(mesh).triangles;
  std::vector<int> nodes(triangles.data(), triangles.data() + triangles.size());
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace pliant
