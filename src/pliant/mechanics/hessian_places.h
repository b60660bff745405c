#pragma once

#include <vector>

#include "pliant/mechanics/lane_kernel.h"
#include "pliant/mechanics/potential.h"

namespace pliant {

/// Where the blocks of stencils stand in a system's Hessian: found once, so that adding them is a
/// walk through the matrix without a search. Only blocks of different nodes are added: those of one
/// node follow from them, as a translation changes no strain (`Coordinates::complete_diagonals`).
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
  static constexpr auto kCouplings = node_couplings<Measure>();
  static constexpr int kCount = static_cast<int>(kCouplings.size());

  // One of the points is not free; else a place is twice the number of the block, plus one when the
  // pair stands in it transposed.
  static constexpr int kThroughCoordinates = -1;

  const int* of_batch(int batch) const {
    return places_.data() + static_cast<size_t>(kLanes) * kCount * batch;
  }
  template <class Number>
  void fetch_ahead(const int* place, const Number* entries) const;

  std::vector<int> places_;  // of each coupling of each stencil
};

template <class Measure>
HessianPlaces<Measure>::HessianPlaces(const Points& points, const Coordinates& coordinates,
                                      const BlockPattern& pattern) {
  places_.reserve(points.size() * kCount);
  for (const auto& nodes : points) {
    for (const auto& [i, j] : kCouplings) {
      const int row = coordinates.row(nodes[static_cast<size_t>(i)]);
      const int column = coordinates.row(nodes[static_cast<size_t>(j)]);
      if (row < 0 || column < 0) {
        places_.push_back(kThroughCoordinates);
      } else if (row < column) {
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
template <class Number>
void HessianPlaces<Measure>::fetch_ahead(const int* place, const Number* entries) const {
  constexpr int kAhead = 4, kLine = 64 / sizeof(Number);  // stencils; numbers of a cache line
  const int* const first = place + kAhead * kCount;
  if (first + kCount > places_.data() + places_.size()) return;
  for (int p = 0; p < kCount; ++p) {
    if (first[p] < 0) continue;
    const Number* const block = entries + 9 * (first[p] / 2);
    __builtin_prefetch(block, 1);
    if (kLine < 9) __builtin_prefetch(block + kLine, 1);
  }
}

template <class Measure>
void HessianPlaces<Measure>::add(int batch, const LaneHessian<Measure>& values,
                                 const Points& points, const Configuration& at,
                                 Hessian& hessian) const {
  hessian.matrix.with_entries([&]<class Number>(Number* entries) {
    const int* place = of_batch(batch);
    for (int l = 0; l < kLanes; ++l, place += kCount) {
      fetch_ahead(place, entries);
      for (int p = 0; p < kCount; ++p) {
        const auto [i, j] = kCouplings[static_cast<size_t>(p)];
        const double* const value = values.data() + l + 9 * kLanes * pair_number<Measure>(i, j);
        if (place[p] == kThroughCoordinates) {
          Eigen::Matrix3d block;
          for (int k = 0; k < 9; ++k) block(k) = value[kLanes * k];
          const auto& nodes = points[static_cast<size_t>(kLanes * batch + l)];
          hessian.coordinates.add_difference(at, nodes[static_cast<size_t>(i)],
                                             nodes[static_cast<size_t>(j)], block, hessian.matrix);
          continue;
        }
        Number* const block = entries + 9 * (place[p] / 2);
        const int along = place[p] & 1 ? 3 : 1, across = 4 - along;  // steps of rows and columns
        for (int b = 0; b < 3; ++b) {
          for (int a = 0; a < 3; ++a) {
            block[3 * b + a] += static_cast<Number>(value[kLanes * (along * a + across * b)]);
          }
        }
      }
    }
  });
}

template <class Measure>
void HessianPlaces<Measure>::add_sum(int batch, const LaneHessian<Measure>& values,
                                     const Points& points, const Configuration& at,
                                     Hessian& hessian) const {
  const int* place = of_batch(batch);
  const auto& nodes = points[static_cast<size_t>(kLanes * batch)];
  for (int p = 0; p < kCount; ++p) {
    const auto [i, j] = kCouplings[static_cast<size_t>(p)];
    Eigen::Matrix3d block;
    for (int k = 0; k < 9; ++k) block(k) = values.col(9 * pair_number<Measure>(i, j) + k).sum();
    if (place[p] == kThroughCoordinates) {
      hessian.coordinates.add_difference(at, nodes[static_cast<size_t>(i)],
                                         nodes[static_cast<size_t>(j)], block, hessian.matrix);
      continue;
    }
    if (place[p] & 1) block.transposeInPlace();
    hessian.matrix.with_entries([&]<class Number>(Number* entries) {
      Eigen::Map<Eigen::Matrix<Number, 3, 3>>(entries + 9 * (place[p] / 2)) +=
          block.template cast<Number>();
    });
  }
}

// Which way a pair stands follows no pattern: it selects addresses instead of ways of the program.
template <class Measure>
void HessianPlaces<Measure>::add_outer_products(int batch, const Lane& factor,
                                                const LanePositions<Measure>& gradient,
                                                const Points& points, const Configuration& at,
                                                Hessian& hessian) const {
  hessian.matrix.with_entries([&]<class Number>(Number* entries) {
    const int* place = of_batch(batch);
    for (int l = 0; l < kLanes; ++l, place += kCount) {
      fetch_ahead(place, entries);
      Number g[Measure::kUnknowns], f[Measure::kUnknowns];
      for (int k = 0; k < Measure::kUnknowns; ++k) {
        g[k] = static_cast<Number>(gradient(l, k));
        f[k] = static_cast<Number>(factor(l) * gradient(l, k));
      }
      for (int p = 0; p < kCount; ++p) {
        const auto [i, j] = kCouplings[static_cast<size_t>(p)];
        if (place[p] == kThroughCoordinates) {
          const Eigen::Matrix3d block =
              factor(l) * gradient.row(l).template segment<3>(3 * i).matrix().transpose() *
              gradient.row(l).template segment<3>(3 * j).matrix();
          const auto& nodes = points[static_cast<size_t>(kLanes * batch + l)];
          hessian.coordinates.add_difference(at, nodes[static_cast<size_t>(i)],
                                             nodes[static_cast<size_t>(j)], block, hessian.matrix);
          continue;
        }
        const int turn = (place[p] & 1) * (j - i);
        const Number* const row = f + 3 * (i + turn);
        const Number* const column = g + 3 * (j - turn);
        Number* const block = entries + 9 * (place[p] / 2);
        const Number r0 = row[0], r1 = row[1], r2 = row[2];
        for (int b = 0; b < 3; ++b) {
          const Number c = column[b];
          block[3 * b] += r0 * c;
          block[3 * b + 1] += r1 * c;
          block[3 * b + 2] += r2 * c;
        }
      }
    }
  });
}

}  // namespace pliant
