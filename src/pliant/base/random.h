#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace pliant {

/// A seeded stream of random numbers that is the same on every platform and compiler
/// (xoshiro256++ of Blackman and Vigna, 2019; the distributions of <random> are not portable).
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed);

  /// 64 uniformly distributed bits.
  std::uint64_t bits();

  /// Uniform in [0, 1).
  double uniform();

  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Standard normal (Marsaglia's polar method).
  double normal();

  /// An independent stream that depends on this stream's seed and on `name` only, not on how many
  /// numbers were drawn: adding a draw in one place leaves every other substream as it was.
  RandomStream split(std::string_view name) const;

 private:
  std::uint64_t seed_;
  std::array<std::uint64_t, 4> state_;
  std::optional<double> spare_normal_;  // the polar method makes two at a time
};

}  // namespace pliant
