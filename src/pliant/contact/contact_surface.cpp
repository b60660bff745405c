#include "pliant/contact/contact_surface.h"

#include <algorithm>
#include <utility>

#include "pliant/geometry/topology.h"

namespace pliant {

/// The boxes of all vertices, edges and faces.
struct ContactSurface::Boxes {
  float reach = 0;
  std::vector<SweptBox> vertices, edges, faces;
};

namespace {

Eigen::Matrix3Xd middles_of(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& faces) {
  Eigen::Matrix3Xd middles(3, faces.cols());
  for (Eigen::Index f = 0; f < faces.cols(); ++f) {
    middles.col(f) = positions(Eigen::all, faces.col(f)).rowwise().mean();
  }
  return middles;
}

template <class Corners>
SweptBox box_of(const Corners& corners, const std::vector<SweptBox>& vertices) {
  SweptBox box = vertices[static_cast<size_t>(corners[0])];
  for (const int corner : corners) box.include(vertices[static_cast<size_t>(corner)]);
  return box;
}

}  // namespace

ContactSurface::ContactSurface(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& faces,
                               std::vector<bool> moves)
    : faces_(faces),
      moves_(std::move(moves)),
      parts_(static_cast<size_t>(faces.cols())),
      tree_(middles_of(positions, faces)) {
  std::vector<bool> is_taken(static_cast<size_t>(positions.cols()), false);
  for (Eigen::Index f = 0; f < faces.cols(); ++f) {
    for (const int vertex : faces.col(f)) {
      if (is_taken[static_cast<size_t>(vertex)]) continue;
      is_taken[static_cast<size_t>(vertex)] = true;
      parts_[static_cast<size_t>(f)].vertices.push_back(vertex);
    }
  }
  for (const MeshEdge& edge : find_edges(faces)) {
    parts_[static_cast<size_t>(edge.triangles[0])].edges.push_back(static_cast<int>(edges_.size()));
    edges_.push_back(edge.vertices);
  }
}

bool ContactSurface::is_held(const SurfacePair& pair) const {
  return std::ranges::none_of(pair.points,
                              [&](int point) { return moves_[static_cast<size_t>(point)]; });
}

void ContactSurface::add_vertices(int of, int face, const Boxes& boxes,
                                  std::vector<SurfacePair>& pairs) const {
  const int a = faces_(0, face), b = faces_(1, face), c = faces_(2, face);
  for (const int vertex : parts_[static_cast<size_t>(of)].vertices) {
    if (vertex == a || vertex == b || vertex == c) continue;
    if (!SweptBox::may_meet(boxes.vertices[static_cast<size_t>(vertex)],
                            boxes.faces[static_cast<size_t>(face)], boxes.reach)) {
      continue;
    }
    const SurfacePair pair{SurfacePair::Kind::vertex_face, {vertex, a, b, c}};
    if (!is_held(pair)) pairs.push_back(pair);
  }
}

void ContactSurface::add_edges(int of, int and_of, const Boxes& boxes,
                               std::vector<SurfacePair>& pairs) const {
  for (const int one : parts_[static_cast<size_t>(of)].edges) {
    for (const int other : parts_[static_cast<size_t>(and_of)].edges) {
      const auto& [a, b] = edges_[static_cast<size_t>(one)];
      const auto& [c, d] = edges_[static_cast<size_t>(other)];
      if (a == c || a == d || b == c || b == d) continue;
      if (!SweptBox::may_meet(boxes.edges[static_cast<size_t>(one)],
                              boxes.edges[static_cast<size_t>(other)], boxes.reach)) {
        continue;
      }
      SurfacePair pair{SurfacePair::Kind::edge_edge, {a, b, c, d}};
      if (c < a) pair.points = {c, d, a, b};
      if (!is_held(pair)) pairs.push_back(pair);
    }
  }
}

std::vector<SurfacePair> ContactSurface::near_pairs(const Eigen::Matrix3Xd& positions,
                                                    const Eigen::Matrix3Xd& ways,
                                                    double reach) const {
  Boxes boxes;
  boxes.reach = static_cast<float>(reach + rounding_of(positions, ways));
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    boxes.vertices.emplace_back(positions.col(i), ways.col(i));
  }
  for (const Edge& edge : edges_) boxes.edges.push_back(box_of(edge, boxes.vertices));
  for (const auto& face : faces_.colwise()) boxes.faces.push_back(box_of(face, boxes.vertices));

  std::vector<SurfacePair> pairs;
  tree_.pairs(boxes.faces, boxes.reach, [&](int one, int other) {
    add_vertices(one, other, boxes, pairs);
    add_vertices(other, one, boxes, pairs);
    add_edges(one, other, boxes, pairs);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace pliant
