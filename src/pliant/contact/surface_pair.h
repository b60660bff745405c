#pragma once

#include <array>
#include <compare>

#include <Eigen/Core>

namespace pliant {

/// Two parts of surfaces that may meet: a vertex and a face, or two edges.
struct SurfacePair {
  enum class Kind : unsigned char { vertex_face, edge_edge };

  Kind kind = Kind::vertex_face;
  std::array<int, 4> points{};  ///< the vertex and the corners of the face; the ends of one edge,
                                ///< then of the other

  auto operator<=>(const SurfacePair&) const = default;
};

/// Places, or ways, of the four points of a pair: one column each.
using PairPoints = Eigen::Matrix<double, 3, 4>;

/// The shortest line between the two parts of a pair.
struct Gap {
  Eigen::Vector4d weights;  ///< of the points: positive on one part, negative on the other, sum 0
  Eigen::Vector3d line;     ///< points * weights (m)

  double distance() const { return line.norm(); }
};

Gap gap_between(SurfacePair::Kind kind, const PairPoints& points);

/// How much of their straight ways four points may go, all alike, before they are nearer to each
/// other than `keep`; 1: all of them. Never too much. By additive advancement (Li et al.,
/// Codimensional Incremental Potential Contact, ACM TOG 40 (2021) 170, section 5), as far each time
/// as planes part them that are at a right angle to the shortest line.
/// @param points  further apart than `keep`
/// @param keep    m, > 0
double free_share(SurfacePair::Kind kind, const PairPoints& points, const PairPoints& ways,
                  double keep);

}  // namespace pliant
