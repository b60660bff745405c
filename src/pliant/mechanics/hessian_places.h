#pragma once

#include <vector>

#include "pliant/mechanics/lane_kernel.h"
#include "pliant/mechanics/potential.h"

namespace pliant {

/// Where the blocks of stencils stand in a system's Hessian: found once, so that adding them is a
/// walk through the matrix without a search.
template <class Measure>
class HessianPlaces {
 public:
  using Points = std::vector<std::array<int, Measure::kNodes>>;  ///< of the stencils

  HessianPlaces() = default;
  HessianPlaces(const Points& points, const Coordinates& coordinates, const BlockPattern& pattern);

  /// Adds the blocks of eight stencils.
  void add(int batch, const LaneHessian<Measure>& values, const Points& points,
           const Configuration& at, Hessian& hessian) const;

  /// The same for eight stencils of the same points, at once.
  void add_sum(int batch, const LaneHessian<Measure>& values, const Points& points,
               const Configuration& at, Hessian& hessian) const;

  /// Adds factor gradient gradient^T of each of eight stencils.
  void add_outer_products(int batch, const Lane& factor, const LanePositions<Measure>& gradient,
                          const Points& points, const Configuration& at, Hessian& hessian) const;

 private:
  static constexpr auto kNodes = node_pairs<Measure>();

  // Where the block of a pair of points goes.
  static constexpr int kNowhere = -1;      // one of the points is moved from outside
  static constexpr int kThroughClip = -2;  // one of the points belongs to a free clip
  // Otherwise twice the number of the block, plus one when the pair stands in it transposed.

  const int* of_batch(int batch) const {
    return places_.data() + static_cast<size_t>(kLanes * kPairs<Measure> * batch);
  }
  void fetch_ahead(const int* place, BlockMatrix& matrix) const;
  static void add_block(int place, const std::array<int, 2>& points, const Eigen::Matrix3d& block,
                        const Configuration& at, Hessian& hessian);

  std::vector<int> places_;  // of each pair of each stencil
};

template <class Measure>
HessianPlaces<Measure>::HessianPlaces(const Points& points, const Coordinates& coordinates,
                                      const BlockPattern& pattern) {
  places_.reserve(points.size() * kPairs<Measure>);
  for (const auto& nodes : points) {
    for (const auto& [i, j] : kNodes) {
      const int p = nodes[static_cast<size_t>(i)], q = nodes[static_cast<size_t>(j)];
      const int row = coordinates.row(p), column = coordinates.row(q);
      if (coordinates.is_prescribed(p) || coordinates.is_prescribed(q)) {
        places_.push_back(kNowhere);
      } else if (row < 0 || column < 0) {
        places_.push_back(kThroughClip);
      } else if (row <= column) {
        places_.push_back(2 * pattern.find(row, column));
      } else {
        places_.push_back(2 * pattern.find(column, row) + 1);
      }
    }
  }
}

// The matrix is larger than the near caches, and its blocks come in no order that a processor
// foresees: it is told of those that a later stencil adds to.
template <class Measure>
void HessianPlaces<Measure>::fetch_ahead(const int* place, BlockMatrix& matrix) const {
  constexpr int kAhead = 4, kLine = 8;  // stencils; numbers of a cache line
  const int* const first = place + kAhead * kPairs<Measure>;
  if (first + kPairs < Measure >> places_.data() + places_.size()) return;
  for (int p = 0; p < kPairs<Measure>; ++p) {
    if (first[p] < 0) continue;
    const double* const block = matrix.block(first[p] / 2).data();
    __builtin_prefetch(block, 1);
    __builtin_prefetch(block + kLine, 1);
  }
}

template <class Measure>
void HessianPlaces<Measure>::add(int batch, const LaneHessian<Measure>& values,
                                 const Points& points, const Configuration& at,
                                 Hessian& hessian) const {
  const int* place = of_batch(batch);
  for (int l = 0; l < kLanes; ++l, place += kPairs<Measure>) {
    const auto& nodes = points[static_cast<size_t>(kLanes * batch + l)];
    for (int p = 0; p < kPairs<Measure>; ++p) {
      if (place[p] == kNowhere) continue;
      const auto [i, j] = kNodes[static_cast<size_t>(p)];
      Eigen::Matrix3d block;
      for (int k = 0; k < 9; ++k) block(k % 3, k / 3) = values(l, 9 * p + k);
      add_block(place[p], {nodes[static_cast<size_t>(i)], nodes[static_cast<size_t>(j)]}, block, at,
                hessian);
    }
  }
}

template <class Measure>
void HessianPlaces<Measure>::add_sum(int batch, const LaneHessian<Measure>& values,
                                     const Points& points, const Configuration& at,
                                     Hessian& hessian) const {
  const int* place = of_batch(batch);
  const auto& nodes = points[static_cast<size_t>(kLanes * batch)];
  for (int p = 0; p < kPairs<Measure>; ++p) {
    if (place[p] == kNowhere) continue;
    const auto [i, j] = kNodes[static_cast<size_t>(p)];
    Eigen::Matrix3d block;
    for (int k = 0; k < 9; ++k) block(k % 3, k / 3) = values.col(9 * p + k).sum();
    add_block(place[p], {nodes[static_cast<size_t>(i)], nodes[static_cast<size_t>(j)]}, block, at,
              hessian);
  }
}

template <class Measure>
void HessianPlaces<Measure>::add_block(int place, const std::array<int, 2>& points,
                                       const Eigen::Matrix3d& block, const Configuration& at,
                                       Hessian& hessian) {
  if (place == kThroughClip) {
    hessian.coordinates.add_coupling(at, points[0], points[1], block, hessian.matrix);
  } else if (place & 1) {
    hessian.matrix.block(place / 2) += block.transpose();
  } else {
    hessian.matrix.block(place / 2) += block;
  }
}

// Which way a pair stands follows no pattern: it selects addresses instead of ways of the program.
template <class Measure>
void HessianPlaces<Measure>::add_outer_products(int batch, const Lane& factor,
                                                const LanePositions<Measure>& gradient,
                                                const Points& points, const Configuration& at,
                                                Hessian& hessian) const {
  const int* place = of_batch(batch);
  for (int l = 0; l < kLanes; ++l, place += kPairs<Measure>) {
    fetch_ahead(place, hessian.matrix);
    double g[Measure::kUnknowns], f[Measure::kUnknowns];
    for (int k = 0; k < Measure::kUnknowns; ++k) {
      g[k] = gradient(l, k);
      f[k] = factor(l) * g[k];
    }
    const auto& nodes = points[static_cast<size_t>(kLanes * batch + l)];
    for (int p = 0; p < kPairs<Measure>; ++p) {
      const auto [i, j] = kNodes[static_cast<size_t>(p)];
      if (place[p] >= 0) {
        const int turn = (place[p] & 1) * (j - i);
        const double* const row = f + 3 * (i + turn);
        const double* const column = g + 3 * (j - turn);
        double* const block = hessian.matrix.block(place[p] / 2).data();
        const double r0 = row[0], r1 = row[1], r2 = row[2];
        for (int b = 0; b < 3; ++b) {
          const double c = column[b];
          block[3 * b] += r0 * c;
          block[3 * b + 1] += r1 * c;
          block[3 * b + 2] += r2 * c;
        }
      } else if (place[p] == kThroughClip) {
        const Eigen::Matrix3d block = Eigen::Map<const Eigen::Vector3d>(f + 3 * i) *
                                      Eigen::Map<const Eigen::RowVector3d>(g + 3 * j);
        hessian.coordinates.add_coupling(at, nodes[static_cast<size_t>(i)],
                                         nodes[static_cast<size_t>(j)], block, hessian.matrix);
      }
    }
  }
}

}  // namespace pliant
