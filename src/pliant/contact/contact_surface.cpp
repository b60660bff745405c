#include "pliant/contact/contact_surface.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "pliant/base/parallel.h"
#include "pliant/geometry/topology.h"

namespace pliant {

/// The boxes of all vertices, edges and faces.
struct ContactSurface::Boxes {
  float reach = 0;
  std::vector<SweptBox> vertices, edges, cloth, bodies;

  const SweptBox& face(int number) const {
    const auto f = static_cast<size_t>(number);
    return f < cloth.size() ? cloth[f] : bodies[f - cloth.size()];
  }
};

namespace {

// How much a search may look at. Whether that is enough does not depend on how its parts take
// turns.
class SearchBudget {
 public:
  explicit SearchBudget(std::int64_t most) : left_(most) {}

  // Takes one for a part of the search: whether that may go on.
  bool lasts(int part) {
    constexpr std::int64_t kTogether = 256;  // before other parts know
    std::int64_t& taken = taken_[static_cast<size_t>(part)].count;
    if (++taken % kTogether == 0) left_ -= kTogether;
    return !is_spent();
  }
  bool is_spent() const { return left_ < 0; }

 private:
  // Apart in memory, as threads write them at once.
  struct alignas(64) Taken {
    std::int64_t count = 0;
  };

  std::atomic<std::int64_t> left_;
  std::array<Taken, BoxTree::kParts> taken_;
};

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

// All pairs of some parts, by halves that are merged. No pair is in two of them, so that there is
// one order.
std::vector<SurfacePair> sorted(std::vector<std::vector<SurfacePair>> parts) {
  parallel_for(static_cast<int>(parts.size()), [&](int i) {
    auto& part = parts[static_cast<size_t>(i)];
    std::sort(part.begin(), part.end());
  });
  while (parts.size() > 1) {
    std::vector<std::vector<SurfacePair>> merged((parts.size() + 1) / 2);
    parallel_for(static_cast<int>(merged.size()), [&](int i) {
      const size_t one = 2 * static_cast<size_t>(i), other = one + 1;
      auto& both = merged[static_cast<size_t>(i)];
      if (other == parts.size()) {
        both = std::move(parts[one]);
        return;
      }
      both.resize(parts[one].size() + parts[other].size());
      std::merge(parts[one].begin(), parts[one].end(), parts[other].begin(), parts[other].end(),
                 both.begin());
    });
    parts = std::move(merged);
  }
  return std::move(parts.front());
}

}  // namespace

ContactSurface::ContactSurface(const Eigen::Matrix3Xd& positions, const Faces& faces,
                               std::vector<bool> moves)
    : faces_(3, faces.cloth.cols() + faces.bodies.cols()),
      moves_(std::move(moves)),
      parts_(static_cast<size_t>(faces_.cols())),
      cloth_(middles_of(positions, faces.cloth)),
      cloth_meets_cloth_(faces.cloth_meets_cloth) {
  faces_ << faces.cloth, faces.bodies;
  if (faces.bodies.cols() > 0) bodies_.emplace(middles_of(positions, faces.bodies));
  std::vector<bool> is_taken(static_cast<size_t>(positions.cols()), false);
  for (Eigen::Index f = 0; f < faces_.cols(); ++f) {
    for (const int vertex : faces_.col(f)) {
      if (is_taken[static_cast<size_t>(vertex)]) continue;
      is_taken[static_cast<size_t>(vertex)] = true;
      parts_[static_cast<size_t>(f)].vertices.push_back(vertex);
    }
  }
  // Bodies may have edges of more than two triangles.
  for (const TriangleSide& side : sides_by_edge(faces_)) {
    const auto [low, high] = std::minmax(side.from, side.to);
    const Edge edge{low, high};
    if (!edges_.empty() && edges_.back() == edge) continue;
    parts_[static_cast<size_t>(side.triangle)].edges.push_back(static_cast<int>(edges_.size()));
    edges_.push_back(edge);
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
    if (!SweptBox::may_meet(boxes.vertices[static_cast<size_t>(vertex)], boxes.face(face),
                            boxes.reach)) {
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

void ContactSurface::add_pairs(int one, int other, const Boxes& boxes,
                               std::vector<SurfacePair>& pairs) const {
  add_vertices(one, other, boxes, pairs);
  add_vertices(other, one, boxes, pairs);
  add_edges(one, other, boxes, pairs);
}

std::optional<std::vector<SurfacePair>> ContactSurface::near_pairs_among(
    std::int64_t most, const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xd& ways,
    double reach) const {
  const Boxes boxes = boxes_of(positions, ways, reach);
  std::vector<std::vector<SurfacePair>> parts(BoxTree::kParts);
  SearchBudget budget(most);
  if (cloth_meets_cloth_) {
    cloth_.pairs(boxes.cloth, boxes.reach, [&](int part, int one, int other) {
      add_pairs(one, other, boxes, parts[static_cast<size_t>(part)]);
      return budget.lasts(part);
    });
  }
  if (bodies_) {
    const int first_of_bodies = static_cast<int>(boxes.cloth.size());
    cloth_.pairs_with(*bodies_, boxes.cloth, boxes.bodies, boxes.reach, [&](int one, int other) {
      add_pairs(one, first_of_bodies + other, boxes, parts.front());
      return budget.lasts(0);
    });
  }
  if (budget.is_spent()) return std::nullopt;
  return sorted(std::move(parts));
}

ContactSurface::Boxes ContactSurface::boxes_of(const Eigen::Matrix3Xd& positions,
                                               const Eigen::Matrix3Xd& ways, double reach) const {
  Boxes boxes;
  boxes.reach = static_cast<float>(reach + rounding_of(positions, ways));
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    boxes.vertices.emplace_back(positions.col(i), ways.col(i));
  }
  for (const Edge& edge : edges_) boxes.edges.push_back(box_of(edge, boxes.vertices));
  for (Eigen::Index f = 0; f < faces_.cols(); ++f) {
    auto& own = f < cloth_.size() ? boxes.cloth : boxes.bodies;
    own.push_back(box_of(faces_.col(f), boxes.vertices));
  }
  return boxes;
}

}  // namespace pliant
