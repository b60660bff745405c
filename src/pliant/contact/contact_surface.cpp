#include "pliant/contact/contact_surface.h"

#include <algorithm>
#include <set>
#include <utility>

namespace pliant {
namespace {

bool share_a_point(const SurfacePair& pair) {
  const auto& [a, b, c, d] = pair.points;
  if (pair.kind == SurfacePair::Kind::vertex_face) return a == b || a == c || a == d;
  return a == c || a == d || b == c || b == d;
}

// What boxes of the parts say, which is quick.
bool may_meet(const SurfacePair& pair, const Eigen::Matrix3Xd& positions,
              const Eigen::Matrix3Xd& ways, double reach) {
  const int split = pair.kind == SurfacePair::Kind::vertex_face ? 1 : 2;
  const auto x = positions(Eigen::all, pair.points), w = ways(Eigen::all, pair.points);
  for (int axis = 0; axis < 3; ++axis) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    double least[2] = {INFINITY, INFINITY}, most[2] = {-INFINITY, -INFINITY};
    for (int k = 0; k < 4; ++k) {
      const int part = k < split ? 0 : 1;
      low[part] = std::min(low[part], x(axis, k));
      high[part] = std::max(high[part], x(axis, k));
      least[part] = std::min(least[part], w(axis, k));
      most[part] = std::max(most[part], w(axis, k));
    }
    const double back = std::min(least[0] - most[1], 0.0),
                 forth = std::max(most[0] - least[1], 0.0);
    if (low[0] + back - reach > high[1] || high[0] + forth + reach < low[1]) return false;
  }
  return true;
}

}  // namespace

ContactSurface::ContactSurface(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& faces,
                               std::vector<bool> moves)
    : faces_(faces),
      moves_(std::move(moves)),
      parts_(static_cast<size_t>(faces.cols())),
      tree_(positions, faces) {
  std::set<int> vertices;
  std::set<Edge> edges;
  for (Eigen::Index f = 0; f < faces.cols(); ++f) {
    Parts& parts = parts_[static_cast<size_t>(f)];
    for (int k = 0; k < 3; ++k) {
      const int from = faces(k, f), to = faces((k + 1) % 3, f);
      const Edge edge{std::min(from, to), std::max(from, to)};
      if (vertices.insert(from).second) parts.vertices.push_back(from);
      if (edges.insert(edge).second) parts.edges.push_back(edge);
    }
  }
}

bool ContactSurface::counts(const SurfacePair& pair) const {
  const bool moves = std::ranges::any_of(
      pair.points, [&](int point) { return moves_[static_cast<size_t>(point)]; });
  return moves && !share_a_point(pair);
}

std::vector<SurfacePair> ContactSurface::near_pairs(const Eigen::Matrix3Xd& positions,
                                                    const Eigen::Matrix3Xd& ways,
                                                    double reach) const {
  std::vector<SurfacePair> pairs;
  const auto add = [&](const SurfacePair& pair) {
    if (counts(pair) && may_meet(pair, positions, ways, reach)) pairs.push_back(pair);
  };
  const auto add_vertices = [&](int of, int face) {
    for (const int vertex : parts_[static_cast<size_t>(of)].vertices) {
      add({SurfacePair::Kind::vertex_face,
           {vertex, faces_(0, face), faces_(1, face), faces_(2, face)}});
    }
  };
  tree_.pairs(positions, ways, reach, [&](int one, int other) {
    add_vertices(one, other);
    add_vertices(other, one);
    for (const Edge& a : parts_[static_cast<size_t>(one)].edges) {
      for (const Edge& b : parts_[static_cast<size_t>(other)].edges) {
        const auto& [first, second] = std::minmax(a, b);
        add({SurfacePair::Kind::edge_edge, {first[0], first[1], second[0], second[1]}});
      }
    }
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace pliant
