#include "pliant/measurement/session/middle_line.h"

#include <cmath>

#include "pliant/geometry/mesh_quality.h"

namespace pliant {

std::vector<int> middle_line(const TriangleMesh& rest, int along) {
  const Eigen::RowVectorXd across = rest.positions.row(1 - along);
  const double middle = (across.minCoeff() + across.maxCoeff()) / 2;
  const double reach = mesh_quality(rest).mean_edge / 3;
  Eigen::Index nearest = 0;
  const double distance = (across.array() - middle).abs().minCoeff(&nearest);
  const double line = distance > reach ? across(nearest) : middle;
  std::vector<int> vertices;
  for (int vertex = 0; vertex < rest.vertex_count(); ++vertex) {
    if (std::abs(across(vertex) - line) <= reach) vertices.push_back(vertex);
  }
  return vertices;
}

}  // namespace pliant
