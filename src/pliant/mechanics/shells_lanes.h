#pragma once

#include <cmath>

#include "pliant/material/strain/discrete_shells.h"
#include "pliant/mechanics/lane_kernel.h"

namespace pliant {

/// Eight hinges at once; the formulas are those of DiscreteShells. Rows and columns of a Hessian
/// sum to zero over the nodes, so that those of the edge's first node follow from the others.
template <>
class LaneKernel<DiscreteShells> {
 public:
  LaneKernel(const DiscreteShells::Rest* rests, const LanePositions<DiscreteShells>& positions,
             bool differentiated = true)
      : rests_(rests), positions_(positions) {
    const auto node = [&](int i) -> LaneVector {
      return {positions.col(3 * i), positions.col(3 * i + 1), positions.col(3 * i + 2)};
    };
    edge_ = node(1) - node(0);
    side_[0] = node(2) - node(0);
    side_[1] = node(3) - node(0);
    normal_[0] = cross(edge_, side_[0]);
    normal_[1] = cross(side_[1], edge_);
    squared_length_ = dot(edge_, edge_);
    length_ = squared_length_.sqrt();
    sine_ = dot(cross(normal_[0], normal_[1]), edge_) / length_;
    cosine_ = dot(normal_[0], normal_[1]);
    if (!differentiated) return;
    for (int l = 0; l < kLanes; ++l) scale_(l) = 3 / rests[l].height;
    for (int w = 0; w < 2; ++w) {
      share_[w] = dot(side_[w], edge_) / squared_length_;
      gradient_[2 + w] = Lane(-scale_ * length_ / dot(normal_[w], normal_[w])) * normal_[w];
    }
    gradient_[1] = Lane(-share_[0]) * gradient_[2] - share_[1] * gradient_[3];
    gradient_[0] = Lane(share_[0] - 1) * gradient_[2] - Lane(1 - share_[1]) * gradient_[3];
  }

  LaneStrains strain() const {
    LaneStrains result(kLanes, 1);
    for (int l = 0; l < kLanes; ++l) {
      const DiscreteShells::Rest& rest = rests_[l];
      const double angle = continued_angle(std::atan2(sine_(l), cosine_(l)), rest.near_angle);
      result(l, 0) = 3 * (angle - rest.angle) / rest.height;
    }
    return result;
  }

  void gradient(const Response& response, const Lane& size,
                LanePositions<DiscreteShells>& result) const {
    const Lane stress = size * response.stress.col(0);
    for (int i = 0; i < 4; ++i) {
      result.col(3 * i) = stress * gradient_[i].x;
      result.col(3 * i + 1) = stress * gradient_[i].y;
      result.col(3 * i + 2) = stress * gradient_[i].z;
    }
  }

  /// The convex Hessian, factor gradient gradient^T.
  void outer_product(const Response& response, const Lane& size, Lane& factor,
                     LanePositions<DiscreteShells>& gradient) const {
    factor = size * response.tangent.col(0);
    for (int i = 0; i < 4; ++i) {
      gradient.col(3 * i) = gradient_[i].x;
      gradient.col(3 * i + 1) = gradient_[i].y;
      gradient.col(3 * i + 2) = gradient_[i].z;
    }
  }

  void hessian(const Response& response, const Lane& size, bool convex,
               LaneHessian<DiscreteShells>& result) const {
    const Lane tangent = size * response.tangent.col(0);
    for (int i = convex ? 0 : 1; i < 4; ++i) {
      const LaneVector row = tangent * gradient_[i];
      for (int j = i; j < 4; ++j) {
        const LaneVector& column = gradient_[j];
        const Lane* const columns[3] = {&column.x, &column.y, &column.z};
        const int first = 9 * pair_number<DiscreteShells>(i, j);
        for (int b = 0; b < 3; ++b) {
          result.col(first + 3 * b) = row.x * *columns[b];
          result.col(first + 3 * b + 1) = row.y * *columns[b];
          result.col(first + 3 * b + 2) = row.z * *columns[b];
        }
      }
    }
    if (convex) return;
    add_stress_part(size * response.stress.col(0), result);
    complete_first_node(result);
  }

  DiscreteShells::Positions at(int lane) const {
    DiscreteShells::Positions x;
    for (int k = 0; k < 12; ++k) x(k % 3, k / 3) = positions_(lane, k);
    return x;
  }

 private:
  struct LaneMatrix {
    Lane entry[3][3];
  };

  // d vertex gradient / d side of a wing: by_normal turn [edge]x, with the row n_a of the normal's
  // derivative -scale |e| / n^2 (I - 2 n n^T / n^2).
  LaneMatrix by_side(int wing) const { return by_normal_times_cross(wing, edge_, 1); }

  // d vertex gradient / d edge: -scale n e^T / (n^2 |e|) - by_normal turn [side]x.
  LaneMatrix by_edge(int wing) const {
    LaneMatrix m = by_normal_times_cross(wing, side_[wing], -1);
    const Lane factor = -scale_ / (dot(normal_[wing], normal_[wing]) * length_);
    const LaneVector column = factor * normal_[wing];
    add_outer(column, edge_, m);
    return m;
  }

  LaneMatrix by_normal_times_cross(int wing, const LaneVector& a, double sign) const {
    const LaneVector& n = normal_[wing];
    const Lane squared = dot(n, n);
    const double turn = wing == 0 ? 1 : -1;
    const Lane factor = -scale_ * length_ / squared * (sign * turn);
    // n^T [a]x = (n x a)^T
    const LaneVector row = Lane(-2 * factor / squared) * cross(n, a);
    LaneMatrix m{{{Lane::Zero(), -factor * a.z, factor * a.y},
                  {factor * a.z, Lane::Zero(), -factor * a.x},
                  {-factor * a.y, factor * a.x, Lane::Zero()}}};
    add_outer(n, row, m);
    return m;
  }

  static void add_outer(const LaneVector& a, const LaneVector& b, LaneMatrix& m) {
    const Lane* const rows[3] = {&a.x, &a.y, &a.z};
    const Lane* const columns[3] = {&b.x, &b.y, &b.z};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m.entry[i][j] += *rows[i] * *columns[j];
    }
  }

  // Adds factor * m to block (i, j), i <= j.
  static void add_block(int i, int j, const Lane& factor, const LaneMatrix& m,
                        LaneHessian<DiscreteShells>& result) {
    const int first = 9 * pair_number<DiscreteShells>(i, j);
    for (int b = 0; b < 3; ++b) {
      for (int a = 0; a < 3; ++a) result.col(first + 3 * b + a) += factor * m.entry[a][b];
    }
  }

  void add_stress_part(const Lane& stress, LaneHessian<DiscreteShells>& result) const {
    const Lane zero = Lane::Zero();
    LaneMatrix second{
        {{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}}};  // block (1, 1)
    for (int w = 0; w < 2; ++w) {
      const LaneMatrix side = by_side(w), edge = by_edge(w);
      const Lane& t = share_[w];
      const LaneVector& g = gradient_[2 + w];
      const LaneVector share_by_side = Lane(-1 / squared_length_) * edge_;
      const LaneVector share_by_edge =
          Lane(-1 / squared_length_) * (side_[w] - Lane(2 * t) * edge_);
      LaneMatrix with_vertex;  // block (1, 2 + w)
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          with_vertex.entry[a][b] = -t * side.entry[a][b];
          second.entry[a][b] -= t * edge.entry[a][b];
        }
      }
      add_outer(g, share_by_side, with_vertex);
      add_outer(g, share_by_edge, second);
      add_block(2 + w, 2 + w, stress, side, result);
      add_block(1, 2 + w, stress, with_vertex, result);
    }
    add_block(1, 1, stress, second, result);
  }

  // K_0j = -sum of K_ij over i > 0, and K_00 = -sum of K_0j.
  static void complete_first_node(LaneHessian<DiscreteShells>& k) {
    const auto column = [](int i, int j, int a, int b) {
      return 9 * pair_number<DiscreteShells>(i, j) + 3 * b + a;
    };
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        k.col(column(0, 1, a, b)) =
            -k.col(column(1, 1, a, b)) - k.col(column(1, 2, b, a)) - k.col(column(1, 3, b, a));
        k.col(column(0, 2, a, b)) =
            -k.col(column(1, 2, a, b)) - k.col(column(2, 2, a, b)) - k.col(column(2, 3, b, a));
        k.col(column(0, 3, a, b)) =
            -k.col(column(1, 3, a, b)) - k.col(column(2, 3, a, b)) - k.col(column(3, 3, a, b));
        k.col(column(0, 0, a, b)) =
            -k.col(column(0, 1, a, b)) - k.col(column(0, 2, a, b)) - k.col(column(0, 3, a, b));
      }
    }
  }

  const DiscreteShells::Rest* rests_;
  const LanePositions<DiscreteShells>& positions_;
  LaneVector edge_, side_[2], normal_[2];  // of the two wings
  Lane squared_length_, length_, share_[2], scale_;
  LaneVector gradient_[4];  // of the strain, by node
  Lane sine_, cosine_;      // of the angle, times the product of the normals' lengths
};

}  // namespace pliant
