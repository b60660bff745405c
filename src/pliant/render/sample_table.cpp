#include "pliant/render/sample_table.h"

#include <bit>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

std::uint32_t reverse_bits(std::uint32_t x) {
  x = ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
  x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
  x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x >> 8) & 0x00ff00ffU) | ((x & 0x00ff00ffU) << 8);
  return (x >> 16) | (x << 16);
}

/// Owen's nested scrambling of binary digits that stand in reverse order: a permutation in which
/// each bit depends on the lower ones only (Burley2020, listing 2).
std::uint32_t scramble(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return x;
}

/// The largest 24 bits as a float in [0, 1): all of them are exact.
float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }

/// Second dimension of Sobol's sequence, its digits in reverse order.
std::uint32_t reversed_sobol_y(std::uint32_t index) {
  std::uint32_t y = 0;
  for (std::uint32_t direction = 1U << 31; index != 0; index >>= 1) {
    if ((index & 1U) != 0) y ^= direction;
    direction ^= direction >> 1;
  }
  return reverse_bits(y);
}

}  // namespace

std::uint32_t hash_combine(std::uint32_t a, std::uint32_t b) {
  // The finaliser of MurmurHash3 (public domain) over a multiple of the golden ratio.
  std::uint32_t x = a ^ (b * 0x9e3779b9U + 0x7f4a7c15U);
  x ^= x >> 16;
  x *= 0x85ebca6bU;
  x ^= x >> 13;
  x *= 0xc2b2ae35U;
  return x ^ (x >> 16);
}

SampleTable::SampleTable(int count) {
  PLIANT_ASSERT(count > 0, "a table has points");
  const std::uint32_t size = std::bit_ceil(static_cast<std::uint32_t>(count));
  unused_bits_ = 32 - std::countr_zero(size);
  // The first dimension is the index with its digits reversed; here it is reversed once more.
  for (std::uint32_t i = 0; i < size; ++i) points_.push_back({i, reversed_sobol_y(i)});
}

Eigen::Vector2f SampleTable::point(std::uint32_t seed, std::uint32_t index) const {
  // The shuffle scrambles the digits of the index from the highest used one down.
  std::uint32_t shuffled = index;
  if (points_.size() > 1) {
    const std::uint32_t top_aligned = reverse_bits(index << unused_bits_);
    shuffled = reverse_bits(scramble(top_aligned, seed)) >> unused_bits_;
  }
  const Bits& bits = points_[shuffled];
  return {unit_float(reverse_bits(scramble(bits.x, hash_combine(seed, 1)))),
          unit_float(reverse_bits(scramble(bits.y, hash_combine(seed, 2))))};
}

}  // namespace pliant
