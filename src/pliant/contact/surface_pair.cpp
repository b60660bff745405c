#include "pliant/contact/surface_pair.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Eigen::Vector3d;

// Barycentric coordinates of the point of a triangle that is nearest to p: first of its corners,
// then of its sides, then of its inside the one whose region p is in.
Vector3d nearest_of_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                             const Vector3d& c) {
  const Vector3d ab = b - a, ac = c - a;
  const Vector3d ap = p - a, bp = p - b, cp = p - c;
  const double a_b = ab.dot(ap), a_c = ac.dot(ap);
  if (a_b <= 0 && a_c <= 0) return {1, 0, 0};
  const double b_b = ab.dot(bp), b_c = ac.dot(bp);
  if (b_b >= 0 && b_c <= b_b) return {0, 1, 0};
  const double c_b = ab.dot(cp), c_c = ac.dot(cp);
  if (c_c >= 0 && c_b <= c_c) return {0, 0, 1};
  const double beside_ab = a_b * b_c - b_b * a_c;
  if (beside_ab <= 0 && a_b >= 0 && b_b <= 0) {
    const double share = a_b / (a_b - b_b);
    return {1 - share, share, 0};
  }
  const double beside_ac = c_b * a_c - a_b * c_c;
  if (beside_ac <= 0 && a_c >= 0 && c_c <= 0) {
    const double share = a_c / (a_c - c_c);
    return {1 - share, 0, share};
  }
  const double beside_bc = b_b * c_c - c_b * b_c;
  if (beside_bc <= 0 && b_c >= b_b && c_b >= c_c) {
    const double share = (b_c - b_b) / ((b_c - b_b) + (c_b - c_c));
    return {0, 1 - share, share};
  }
  const double sum = beside_ab + beside_ac + beside_bc;
  const double at_b = beside_ac / sum, at_c = beside_ab / sum;
  return {1 - at_b - at_c, at_b, at_c};
}

// Where on each of two edges, from 0 at its first end to 1, the other is nearest.
Eigen::Vector2d nearest_of_edges(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                                 const Vector3d& d) {
  const Vector3d one = b - a, other = d - c, apart = a - c;
  const double one_one = one.squaredNorm(), other_other = other.squaredNorm();
  const double one_other = one.dot(other), one_apart = one.dot(apart),
               other_apart = other.dot(apart);
  const double area = one_one * other_other - one_other * one_other;
  double s = 0;  // of parallel edges any
  if (area > 0) s = std::clamp((one_other * other_apart - one_apart * other_other) / area, 0., 1.);
  double t = (one_other * s + other_apart) / other_other;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0., 1.);
    s = std::clamp((one_other * t - one_apart) / one_one, 0., 1.);
  }
  return {s, t};
}

Eigen::Vector4d weights_of(SurfacePair::Kind kind, const PairPoints& x) {
  if (kind == SurfacePair::Kind::vertex_face) {
    const Vector3d at = nearest_of_triangle(x.col(0), x.col(1), x.col(2), x.col(3));
    return {1, -at(0), -at(1), -at(2)};
  }
  const Eigen::Vector2d at = nearest_of_edges(x.col(0), x.col(1), x.col(2), x.col(3));
  return {1 - at(0), at(0), at(1) - 1, -at(1)};
}

// How fast the parts can come nearer to each other, at most.
double largest_approach(SurfacePair::Kind kind, const PairPoints& ways) {
  const Eigen::Vector4d speeds = ways.colwise().norm();
  if (kind == SurfacePair::Kind::vertex_face) return speeds(0) + speeds.tail<3>().maxCoeff();
  return speeds.head<2>().maxCoeff() + speeds.tail<2>().maxCoeff();
}

// How much of their ways points may go before the parts are nearer than `keep` along a line: planes
// at a right angle to the shortest line between them part them until then. What slides past comes
// no nearer along it.
double share_to_plane(SurfacePair::Kind kind, const PairPoints& points, const PairPoints& ways,
                      const Vector3d& line, double keep) {
  const Vector3d normal = line.normalized();
  const Eigen::Vector4d heights = points.transpose() * normal, rises = ways.transpose() * normal;
  const int first = kind == SurfacePair::Kind::vertex_face ? 1 : 2;
  double share = INFINITY;
  for (int i = 0; i < first; ++i) {
    for (int j = first; j < 4; ++j) {
      const double approach = rises(j) - rises(i);
      if (approach > 0) share = std::min(share, (heights(i) - heights(j) - keep) / approach);
    }
  }
  return share;
}

}  // namespace

Gap gap_between(SurfacePair::Kind kind, const PairPoints& points) {
  const Eigen::Vector4d weights = weights_of(kind, points);
  return {weights, points * weights};
}

double free_share(SurfacePair::Kind kind, const PairPoints& points, const PairPoints& ways,
                  double keep) {
  constexpr double kNear = 0.05;  // of what is kept: near enough to it
  constexpr int kMost = 40;       // few ever need half; what slides along something stops short
  // What all have in common brings none nearer.
  const PairPoints relative = ways.colwise() - ways.rowwise().mean();
  const double approach = largest_approach(kind, relative);
  PairPoints there = points;
  Gap gap = gap_between(kind, there);
  double distance = gap.distance(), share = 0;
  for (int i = 0; i < kMost; ++i) {
    const double further = std::max((distance - keep) / approach,
                                    share_to_plane(kind, there, relative, gap.line, keep));
    if (!(further < 1 - share)) return 1;
    share += further;
    there = points + share * relative;
    gap = gap_between(kind, there);
    distance = gap.distance();
    if (distance - keep < kNear * keep) break;
  }
  return share;
}

}  // namespace pliant
