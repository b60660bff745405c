#include "pliant/geometry/topology.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

std::pair<int, int> edge_of(const TriangleSide& side) { return std::minmax(side.from, side.to); }

}  // namespace

bool same_triangles(const Eigen::Matrix3Xi& a, const Eigen::Matrix3Xi& b) {
  return a.cols() == b.cols() && a == b;
}

std::vector<TriangleSide> sides_by_edge(const Eigen::Matrix3Xi& triangles) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * static_cast<std::size_t>(triangles.cols()));
  for (int t = 0; t < triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) sides.push_back({triangles(k, t), triangles((k + 1) % 3, t), t, k});
  }
  std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
    return std::tuple(edge_of(a), a.triangle, a.corner) <
           std::tuple(edge_of(b), b.triangle, b.corner);
  });
  return sides;
}

std::vector<MeshEdge> find_edges(const Eigen::Matrix3Xi& triangles) {
  std::vector<MeshEdge> edges;
  for (const TriangleSide& side : sides_by_edge(triangles)) {
    const auto [low, high] = edge_of(side);
    const std::array vertices{low, high};
    if (edges.empty() || edges.back().vertices != vertices) {
      edges.push_back({vertices, {side.triangle, -1}});
      continue;
    }
    PLIANT_ASSERT(edges.back().is_boundary(), "an edge has at most two triangles");
    edges.back().triangles[1] = side.triangle;
  }
  return edges;
}

VertexNeighbours::VertexNeighbours(int vertex_count, const Eigen::Matrix3Xi& triangles)
    : begins_(static_cast<std::size_t>(vertex_count) + 1, 0) {
  PLIANT_ASSERT((triangles.array() >= 0).all() && (triangles.array() < vertex_count).all(),
                "triangles have vertices of the mesh");
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(6 * static_cast<std::size_t>(triangles.cols()));
  for (int t = 0; t < triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int from = triangles(k, t), to = triangles((k + 1) % 3, t);
      pairs.emplace_back(from, to);
      pairs.emplace_back(to, from);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  neighbours_.reserve(pairs.size());
  for (const auto& [vertex, neighbour] : pairs) {
    ++begins_[vertex + 1];
    neighbours_.push_back(neighbour);
  }
  std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
}

}  // namespace pliant
