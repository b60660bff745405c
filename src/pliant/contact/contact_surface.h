#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/contact/box_tree.h"
#include "pliant/contact/surface_pair.h"

namespace pliant {

/// Triangles that may meet: those of cloth each other and those of bodies, which are led and do not
/// meet each other.
///
/// Each vertex and each edge belongs to one of its triangles, so that a pair of triangles that are
/// near stands for pairs that no other stands for. Pairs that share a point, or of which no point
/// moves freely, are left out.
class ContactSurface {
 public:
  struct Faces {
    Eigen::Matrix3Xi cloth;        ///< as points of the system, at least one
    Eigen::Matrix3Xi bodies = {};  ///< the same; may be none
    bool cloth_meets_cloth = true;
  };

  /// @param positions  of all points of the system, where those near each other are so always
  /// @param moves      whether a point may be moved by contact
  ContactSurface(const Eigen::Matrix3Xd& positions, const Faces& faces, std::vector<bool> moves);

  /// Whether a point may be moved by contact.
  bool moves(int point) const { return moves_[static_cast<size_t>(point)]; }

  /// All pairs that come nearer than `reach` while all points go straight ways at once, and some
  /// others, sorted.
  std::vector<SurfacePair> near_pairs(const Eigen::Matrix3Xd& positions,
                                      const Eigen::Matrix3Xd& ways, double reach) const {
    constexpr auto kAny = std::numeric_limits<std::int64_t>::max();
    return *near_pairs_among(kAny, positions, ways, reach);
  }
  /// The same where boxes of not many more pairs of triangles than `most` may meet, else nothing.
  std::optional<std::vector<SurfacePair>> near_pairs_among(std::int64_t most,
                                                           const Eigen::Matrix3Xd& positions,
                                                           const Eigen::Matrix3Xd& ways,
                                                           double reach) const;

  Eigen::Index triangles() const { return faces_.cols(); }

 private:
  using Edge = std::array<int, 2>;

  // The parts of a triangle that no other triangle before it has: vertices, and numbers of edges.
  struct Parts {
    std::vector<int> vertices, edges;
  };
  struct Boxes;
  Boxes boxes_of(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xd& ways,
                 double reach) const;

  void add_pairs(int one, int other, const Boxes& boxes, std::vector<SurfacePair>& pairs) const;
  void add_vertices(int of, int face, const Boxes& boxes, std::vector<SurfacePair>& pairs) const;
  void add_edges(int of, int and_of, const Boxes& boxes, std::vector<SurfacePair>& pairs) const;
  bool is_held(const SurfacePair& pair) const;

  Eigen::Matrix3Xi faces_;  // of cloth, then of bodies
  std::vector<Edge> edges_;
  std::vector<bool> moves_;
  std::vector<Parts> parts_;
  BoxTree cloth_;
  std::optional<BoxTree> bodies_;
  bool cloth_meets_cloth_;
};

/// Places of the points of a pair.
template <class Points>
PairPoints points_of(const SurfacePair& pair, const Points& all) {
  PairPoints points;
  for (int k = 0; k < 4; ++k) points.col(k) = all.col(pair.points[static_cast<size_t>(k)]);
  return points;
}

}  // namespace pliant
