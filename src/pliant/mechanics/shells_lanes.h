#pragma once

#include <cmath>
#include <numbers>

#include "pliant/material/strain/discrete_shells.h"
#include "pliant/mechanics/lane_kernel.h"

namespace pliant {

/// Eight hinges at once; the formulas are those of DiscreteShells ([Tamstorf2013]). Rows and
/// columns of a Hessian sum to zero over the nodes, so that those of the edge's first node follow
/// from the others.
template <>
class LaneKernel<DiscreteShells> {
 public:
  LaneKernel(const DiscreteShells::Rest* rests, const LanePositions<DiscreteShells>& positions,
             bool differentiated = true)
      : rests_(rests), positions_(positions) {
    for (int l = 0; l < kLanes; ++l) scale_(l) = rests[l].height;
    simd::run<Geometry>(positions.data(), differentiated, this);
  }

  LaneStrains strain() const {
    LaneStrains result(kLanes, 1);
    Lane near, rest;  // angles
    for (int l = 0; l < kLanes; ++l) {
      near(l) = rests_[l].near_angle;
      rest(l) = rests_[l].angle;
    }
    simd::run<Angles>(this, near.data(), rest.data(), result.data());
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
  // Normals and the angle's sine and cosine; the gradients where they will be asked for.
  struct Geometry {
    template <class V>
    PLIANT_INLINE static void run(const double* positions, bool differentiated,
                                  LaneKernel* kernel) {
      for (int l = 0; l < kLanes; l += simd::kWidth<V>) {
        LaneKernel& k = *kernel;
        const WideVector<V> origin = node<V>(positions + l, 0);
        const WideVector<V> edge = node<V>(positions + l, 1) - origin;
        const WideVector<V> side[2] = {node<V>(positions + l, 2) - origin,
                                       node<V>(positions + l, 3) - origin};
        const WideVector<V> normal[2] = {cross(edge, side[0]), cross(side[1], edge)};
        const V squared_length = dot(edge, edge), length = simd::square_root(squared_length);
        const V scale = 3 / simd::load<V>(k.scale_.data() + l);
        simd::store(dot(cross(normal[0], normal[1]), edge) / length, k.sine_.data() + l);
        simd::store(dot(normal[0], normal[1]), k.cosine_.data() + l);
        simd::store(scale, k.scale_.data() + l);
        if (!differentiated) continue;
        WideVector<V> gradient[2];  // of the wings' vertices
        V share[2];
        for (int w = 0; w < 2; ++w) {
          share[w] = dot(side[w], edge) / squared_length;
          gradient[w] = V(-scale * length / dot(normal[w], normal[w])) * normal[w];
          store(side[w], l, k.side_[w]);
          store(normal[w], l, k.normal_[w]);
          store(gradient[w], l, k.gradient_[2 + w]);
          simd::store(share[w], k.share_[w].data() + l);
        }
        const WideVector<V> at_second = V(-share[0]) * gradient[0] - share[1] * gradient[1];
        const WideVector<V> at_first =
            V(share[0] - 1) * gradient[0] - V(1 - share[1]) * gradient[1];
        store(at_second, l, k.gradient_[1]);
        store(at_first, l, k.gradient_[0]);
        store(edge, l, k.edge_);
        simd::store(squared_length, k.squared_length_.data() + l);
        simd::store(length, k.length_.data() + l);
      }
    }

    template <class V>
    PLIANT_INLINE static WideVector<V> node(const double* positions, int i) {
      const double* const x = positions + 3 * kLanes * i;
      return {simd::load<V>(x), simd::load<V>(x + kLanes), simd::load<V>(x + 2 * kLanes)};
    }
  };

  struct Angles {
    template <class V>
    PLIANT_INLINE static void run(const LaneKernel* kernel, const double* near, const double* rest,
                                  double* strain) {
      constexpr double kTurn = 2 * std::numbers::pi;
      for (int l = 0; l < kLanes; l += simd::kWidth<V>) {
        const V angle = simd::atan2(simd::load<V>(kernel->sine_.data() + l),
                                    simd::load<V>(kernel->cosine_.data() + l));
        const V turns = simd::rounded(V((simd::load<V>(near + l) - angle) / kTurn));
        const V scale = simd::load<V>(kernel->scale_.data() + l);
        simd::store(V(scale * (angle + kTurn * turns - simd::load<V>(rest + l))), strain + l);
      }
    }
  };

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
