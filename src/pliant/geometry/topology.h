#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// Whether two meshes, of any size, have the same triangles: the same vertices at each corner.
bool same_triangles(const Eigen::Matrix3Xi& a, const Eigen::Matrix3Xi& b);

/// A side of a triangle, in the triangle's direction.
struct TriangleSide {
  int from = 0, to = 0;  ///< vertices
  int triangle = 0;
  int corner = 0;  ///< of `from` in the triangle
};

/// All sides of all triangles, those of one edge together: by the smaller, then the larger of its
/// vertices, then by triangle.
/// @param triangles  vertices of each triangle, one column a triangle
std::vector<TriangleSide> sides_by_edge(const Eigen::Matrix3Xi& triangles);

/// An edge of a manifold mesh.
struct MeshEdge {
  std::array<int, 2> vertices{};   ///< the smaller first
  std::array<int, 2> triangles{};  ///< the second is -1 at the boundary

  bool is_boundary() const { return triangles[1] < 0; }
};

/// All edges, by their vertices.
/// @throws AssertionError for an edge with more than two triangles
std::vector<MeshEdge> find_edges(const Eigen::Matrix3Xi& triangles);

/// The vertices that share an edge with each vertex (its first ring).
class VertexNeighbours {
 public:
  VertexNeighbours(int vertex_count, const Eigen::Matrix3Xi& triangles);

  /// The neighbours of a vertex, in rising order.
  std::span<const int> operator[](int vertex) const {
    return std::span(neighbours_).subspan(begins_[vertex], begins_[vertex + 1] - begins_[vertex]);
  }
  int vertex_count() const { return static_cast<int>(begins_.size()) - 1; }

 private:
  std::vector<std::size_t> begins_;  // of each vertex in neighbours_, and the end of the last
  std::vector<int> neighbours_;
};

}  // namespace pliant
