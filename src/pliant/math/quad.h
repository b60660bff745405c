#pragma once

#include <cstring>

#include <Eigen/Core>

namespace pliant {

/// Three numbers of one block row, which the compiler keeps in one register; the fourth means
/// nothing.
using Quad = float __attribute__((vector_size(16)));

/// A 3x3 block by its columns.
struct QuadBlock {
  Quad column[3];
};

inline Quad spread(const Quad& x, int k) { return Quad{x[k], x[k], x[k], x[k]}; }

inline Quad quad(const Eigen::Vector3d& x) {
  return Quad{static_cast<float>(x(0)), static_cast<float>(x(1)), static_cast<float>(x(2)), 0};
}

inline QuadBlock quad_block(const Eigen::Ref<const Eigen::Matrix3d>& m) {
  return {{quad(m.col(0)), quad(m.col(1)), quad(m.col(2))}};
}

inline Eigen::Vector3d vector(const Quad& x) { return {x[0], x[1], x[2]}; }

inline double dot(const Quad& x, const Quad& y) {
  const Quad p = x * y;
  return static_cast<double>(p[0] + p[1] + p[2]);
}

/// Blocks stand in memory as nine numbers each, one after the other; behind the last is room for
/// one number more.
inline constexpr int kBlockSize = 9;

inline QuadBlock load_block(const float* entries) {
  QuadBlock block;
  for (int c = 0; c < 3; ++c) std::memcpy(&block.column[c], entries + 3 * c, sizeof(Quad));
  return block;
}

inline void store_block(const QuadBlock& block, float* entries) {
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) entries[3 * c + r] = block.column[c][r];
  }
}

inline Quad product(const QuadBlock& block, const Quad& x) {
  return block.column[0] * spread(x, 0) + block.column[1] * spread(x, 1) +
         block.column[2] * spread(x, 2);
}

inline Quad transposed_product(const QuadBlock& block, const Quad& x) {
  const Quad a = block.column[0] * x, b = block.column[1] * x, c = block.column[2] * x;
  // The sums within a, within b and within c: the table of three columns, transposed and added up.
  const Quad ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);   // a0 b0 a1 b1
  const Quad ab_high = __builtin_shufflevector(a, b, 2, 6, 2, 6);  // a2 b2
  return __builtin_shufflevector(ab_low, c, 0, 1, 4, 4) +
         __builtin_shufflevector(ab_low, c, 2, 3, 5, 5) +
         __builtin_shufflevector(ab_high, c, 0, 1, 6, 6);
}

inline QuadBlock transposed(const QuadBlock& block) {
  QuadBlock result;
  for (int r = 0; r < 3; ++r) {
    result.column[r] = Quad{block.column[0][r], block.column[1][r], block.column[2][r], 0};
  }
  return result;
}

}  // namespace pliant
