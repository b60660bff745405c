#pragma once

#include <array>

#include "pliant/material/density/density.h"
#include "pliant/mechanics/lane_vector.h"

namespace pliant {

/// Positions of the nodes of eight stencils, or the energy's gradients by them: column 3 i + a
/// belongs to axis a of node i.
template <class Measure>
using LanePositions = Eigen::Array<double, kLanes, Measure::kUnknowns>;

template <class Measure>
inline constexpr int kPairs = Measure::kNodes*(Measure::kNodes + 1) / 2;

/// The pairs of nodes (i, j), i <= j, of a stencil, row by row.
template <class Measure>
constexpr auto node_pairs() {
  std::array<std::array<int, 2>, kPairs<Measure>> pairs{};
  size_t next = 0;
  for (int i = 0; i < Measure::kNodes; ++i) {
    for (int j = i; j < Measure::kNodes; ++j) pairs[next++] = {i, j};
  }
  return pairs;
}

/// Those of different nodes.
template <class Measure>
constexpr auto node_couplings() {
  std::array<std::array<int, 2>, kPairs<Measure> - Measure::kNodes> couplings{};
  size_t next = 0;
  for (const auto& [i, j] : node_pairs<Measure>()) {
    if (i != j) couplings[next++] = {i, j};
  }
  return couplings;
}

/// The number of pair (i, j), i <= j, among `node_pairs`.
template <class Measure>
constexpr int pair_number(int i, int j) {
  return i * Measure::kNodes - i * (i - 1) / 2 + j - i;
}

/// Hessians of eight stencils: column 9 p + 3 b + a holds row a and column b of the block of pair
/// p.
template <class Measure>
using LaneHessian = Eigen::Array<double, kLanes, 9 * kPairs<Measure>>;

/// Eight stencils at once: strains, and forces and stiffness from a density's response. This one
/// goes through the measure stencil by stencil; measures that matter for speed have their own.
template <class Measure>
class LaneKernel {
 public:
  /// @param rests  of eight stencils; they and `positions` outlive the kernel
  /// @param differentiated  whether forces or stiffness will be asked for; kernels may save that
  LaneKernel(const typename Measure::Rest* rests, const LanePositions<Measure>& positions,
             bool /*differentiated*/ = true)
      : rests_(rests), positions_(positions) {}

  LaneStrains strain() const {
    LaneStrains result(kLanes, Measure::kStrains);
    for (int l = 0; l < kLanes; ++l) {
      result.row(l) = Measure::strain(rests_[l], at(l)).transpose();
    }
    return result;
  }

  /// size times the gradients of the strains, contracted with the stress.
  void gradient(const Response& response, const Lane& size, LanePositions<Measure>& result) const {
    for (int l = 0; l < kLanes; ++l) {
      const auto gradient = Measure::gradient(rests_[l], at(l));
      result.row(l) = size(l) * (stress(response, l).transpose() * gradient);
    }
  }

  /// @param convex  with a positive semidefinite stand-in for the part of the stress; the tangent
  ///                of `response` is then positive semidefinite already
  void hessian(const Response& response, const Lane& size, bool convex,
               LaneHessian<Measure>& result) const {
    for (int l = 0; l < kLanes; ++l) hessian_of(l, response, size, convex, result);
  }

  /// Positions of one stencil.
  typename Measure::Positions at(int lane) const {
    typename Measure::Positions x;
    for (int k = 0; k < Measure::kUnknowns; ++k) x(k % 3, k / 3) = positions_(lane, k);
    return x;
  }

 private:
  void hessian_of(int lane, const Response& response, const Lane& size, bool convex,
                  LaneHessian<Measure>& result) const {
    const auto x = at(lane);
    const auto gradient = Measure::gradient(rests_[lane], x);
    const typename Measure::Strain y = stress(response, lane);
    typename Measure::Hessian k = convex ? Measure::convex_weighted_hessian(rests_[lane], x, y)
                                         : Measure::weighted_hessian(rests_[lane], x, y);
    Eigen::Matrix<double, Measure::kStrains, Measure::kStrains> tangent;
    for (int i = 0; i < tangent.size(); ++i) tangent(i) = response.tangent(lane, i);
    k += gradient.transpose() * (tangent * gradient).eval();
    int column = 0;
    for (const auto& [i, j] : node_pairs<Measure>()) {
      for (int b = 0; b < 3; ++b) {
        for (int a = 0; a < 3; ++a) result(lane, column++) = size(lane) * k(3 * i + a, 3 * j + b);
      }
    }
  }

  static typename Measure::Strain stress(const Response& response, int lane) {
    return response.stress.row(lane).transpose().matrix();
  }

  const typename Measure::Rest* rests_;
  const LanePositions<Measure>& positions_;
};

}  // namespace pliant
