#pragma once

#include <cstring>

#include <Eigen/Core>

#include "pliant/math/simd.h"

namespace pliant {

/// Three numbers of one block row, which the compiler keeps in one register; the fourth means
/// nothing.
using Quad = float __attribute__((vector_size(16)));

/// A 3x3 block by its columns.
struct QuadBlock {
  Quad column[3];
};

PLIANT_INLINE Quad spread(const Quad& x, int k) { return Quad{x[k], x[k], x[k], x[k]}; }

PLIANT_INLINE Quad quad(const Eigen::Vector3d& x) {
  return Quad{static_cast<float>(x(0)), static_cast<float>(x(1)), static_cast<float>(x(2)), 0};
}

/// @param entries  nine, column by column
template <class Number>
PLIANT_INLINE QuadBlock quad_block(const Number* entries) {
  QuadBlock block;
  for (int c = 0; c < 3; ++c) {
    const Number* const e = entries + 3 * c;
    block.column[c] =
        Quad{static_cast<float>(e[0]), static_cast<float>(e[1]), static_cast<float>(e[2]), 0};
  }
  return block;
}

PLIANT_INLINE Eigen::Vector3d vector(const Quad& x) { return {x[0], x[1], x[2]}; }

PLIANT_INLINE double dot(const Quad& x, const Quad& y) {
  const Quad p = x * y;
  return static_cast<double>(p[0] + p[1] + p[2]);
}

/// Blocks stand in memory as nine numbers each, one after the other; behind the last is room for
/// one number more.
inline constexpr int kBlockSize = 9;

PLIANT_INLINE QuadBlock load_block(const float* entries) {
  QuadBlock block;
  for (int c = 0; c < 3; ++c) std::memcpy(&block.column[c], entries + 3 * c, sizeof(Quad));
  return block;
}

PLIANT_INLINE void store_block(const QuadBlock& block, float* entries) {
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) entries[3 * c + r] = block.column[c][r];
  }
}

PLIANT_INLINE Quad product(const QuadBlock& block, const Quad& x) {
  return block.column[0] * spread(x, 0) + block.column[1] * spread(x, 1) +
         block.column[2] * spread(x, 2);
}

PLIANT_INLINE Quad transposed_product(const QuadBlock& block, const Quad& x) {
  const Quad a = block.column[0] * x, b = block.column[1] * x, c = block.column[2] * x;
  // The sums within a, within b and within c: the table of three columns, transposed and added up.
  const Quad ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);   // a0 b0 a1 b1
  const Quad ab_high = __builtin_shufflevector(a, b, 2, 6, 2, 6);  // a2 b2
  return __builtin_shufflevector(ab_low, c, 0, 1, 4, 4) +
         __builtin_shufflevector(ab_low, c, 2, 3, 5, 5) +
         __builtin_shufflevector(ab_high, c, 0, 1, 6, 6);
}

PLIANT_INLINE QuadBlock transposed(const QuadBlock& block) {
  QuadBlock result;
  for (int r = 0; r < 3; ++r) {
    result.column[r] = Quad{block.column[0][r], block.column[1][r], block.column[2][r], 0};
  }
  return result;
}

}  // namespace pliant
