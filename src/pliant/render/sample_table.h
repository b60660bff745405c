#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// Mixes two numbers into one of which every bit depends on every bit of both.
std::uint32_t hash_combine(std::uint32_t a, std::uint32_t b);

/// Evenly spread points of the unit square: the first two dimensions of Sobol's sequence, shuffled
/// and scrambled by Owen's method with a hash (Burley2020). Each seed gives another set, as even as
/// the first; the same seed always the same one.
class SampleTable {
 public:
  /// @param count  points that will be asked for, > 0
  explicit SampleTable(int count);

  /// Point `index` < count of the set `seed`, in [0, 1) x [0, 1).
  Eigen::Vector2f point(std::uint32_t seed, std::uint32_t index) const;

 private:
  struct Bits {
    std::uint32_t x, y;  // bits in reverse: the first binary digit is the lowest
  };

  std::vector<Bits> points_;  // a power of two of them
  int unused_bits_ = 0;       // of a 32-bit index
};

}  // namespace pliant
