#include "pliant/geometry/rest_patch.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

using Edge = std::pair<int, int>;  // its vertices in ascending order

Edge edge_of(const Eigen::Matrix3Xi& triangles, Eigen::Index t, int k) {
  const int a = triangles(k, t), b = triangles((k + 1) % 3, t);
  return {std::min(a, b), std::max(a, b)};
}

// The mesh in the rest plane. A vertex on a seam has several places there: each becomes a vertex.
TriangleMesh laid_out(const TriangleMesh& mesh) {
  std::map<std::tuple<int, double, double>, int> numbers;
  std::vector<Eigen::Vector2d> places;
  Eigen::Matrix3Xi triangles(3, mesh.triangle_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d place = mesh.rest_corners.col(3 * t + k);
      const auto [found, fresh] = numbers.emplace(
          std::tuple(mesh.triangles(k, t), place.x(), place.y()), static_cast<int>(places.size()));
      if (fresh) places.push_back(place);
      triangles(k, t) = found->second;
    }
  }
  Eigen::Matrix2Xd vertices(2, std::ssize(places));
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) vertices.col(i) = places[i];
  return flat_mesh(vertices, triangles);
}

std::map<Edge, std::vector<int>> triangles_at_edges(const TriangleMesh& mesh) {
  std::map<Edge, std::vector<int>> result;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) result[edge_of(mesh.triangles, t, k)].push_back(t);
  }
  return result;
}

std::vector<std::vector<int>> neighbours(const TriangleMesh& mesh) {
  std::vector<std::vector<int>> result(mesh.vertex_count());
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    for (int k = 0; k < 3; ++k) {
      result[mesh.triangles(k, t)].push_back(mesh.triangles((k + 1) % 3, t));
      result[mesh.triangles((k + 1) % 3, t)].push_back(mesh.triangles(k, t));
    }
  }
  return result;
}

// Breadth first from the rim.
std::vector<int> depths_of(const TriangleMesh& mesh,
                           const std::map<Edge, std::vector<int>>& triangles_at) {
  std::vector<int> depths(mesh.vertex_count(), -1), front;
  const auto reach = [&](int vertex, int depth, std::vector<int>& reached) {
    if (depths[vertex] >= 0) return;
    depths[vertex] = depth;
    reached.push_back(vertex);
  };
  for (const auto& [edge, triangles] : triangles_at) {
    if (triangles.size() > 1) continue;
    reach(edge.first, 0, front);
    reach(edge.second, 0, front);
  }
  const std::vector<std::vector<int>> next_to = neighbours(mesh);
  for (int depth = 1; !front.empty(); ++depth) {
    std::vector<int> reached;
    for (const int vertex : front) {
      for (const int neighbour : next_to[vertex]) reach(neighbour, depth, reached);
    }
    front = std::move(reached);
  }
  return depths;
}

int triangle_at_deepest_vertex(const TriangleMesh& mesh, const std::vector<int>& depths) {
  const auto deepest = std::max_element(depths.begin(), depths.end()) - depths.begin();
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    if ((mesh.triangles.col(t).array() == static_cast<int>(deepest)).any()) return t;
  }
  return 0;
}

// Triangles in the order in which they are reached across edges.
std::vector<int> grown_from(int first, const TriangleMesh& mesh,
                            const std::map<Edge, std::vector<int>>& triangles_at,
                            int max_triangles) {
  std::vector<int> piece{first};
  std::vector<bool> taken(mesh.triangle_count(), false);
  taken[first] = true;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      for (const int next : triangles_at.at(edge_of(mesh.triangles, piece[i], k))) {
        if (taken[next] || static_cast<int>(piece.size()) >= max_triangles) continue;
        taken[next] = true;
        piece.push_back(next);
      }
    }
  }
  return piece;
}

// The triangles of a piece alone, its vertices numbered anew.
TriangleMesh cut_out(const TriangleMesh& mesh, const std::vector<int>& piece) {
  std::vector<int> numbers(mesh.vertex_count(), -1), kept;
  Eigen::Matrix3Xi triangles(3, std::ssize(piece));
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int vertex = mesh.triangles(k, piece[t]);
      if (numbers[vertex] < 0) {
        numbers[vertex] = static_cast<int>(kept.size());
        kept.push_back(vertex);
      }
      triangles(k, t) = numbers[vertex];
    }
  }
  Eigen::Matrix2Xd vertices(2, std::ssize(kept));
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
    vertices.col(i) = mesh.positions.col(kept[i]).head<2>();
  }
  return flat_mesh(vertices, triangles);
}

}  // namespace

RestPatch rest_patch(const TriangleMesh& mesh, int max_triangles) {
  PLIANT_ASSERT(mesh.triangle_count() > 0 && max_triangles > 0, "a piece has triangles");
  const TriangleMesh flat = laid_out(mesh);
  const auto triangles_at = triangles_at_edges(flat);
  const int first = triangle_at_deepest_vertex(flat, depths_of(flat, triangles_at));
  RestPatch patch;
  patch.mesh = cut_out(flat, grown_from(first, flat, triangles_at, max_triangles));
  patch.depths = depths_of(patch.mesh, triangles_at_edges(patch.mesh));
  return patch;
}

}  // namespace pliant
