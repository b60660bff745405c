#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/pattern.h"

namespace pliant {

/// Irregular texture without waves shorter than a length, seen at the pixels of a picture.
///
/// An octave is a quadratic B-spline on a grid of random numbers, from which the best approximation
/// on a grid twice as coarse was taken away: what is left has waves of two to four grid steps, and
/// next to nothing else across [CookDeRose2005]. Steps are two thirds of the finest length: a
/// spline has 0.2 % of its power in waves shorter than that, and half waves of the finest octave,
/// speckles, are about as long. Each octave has half the power of the one before.
class WaveletNoise {
 public:
  /// @param cloth          its seed, finest length and octaves
  /// @param columns, rows  pixels
  /// @param pixel          side (m)
  WaveletNoise(const ClothPattern& cloth, int columns, int rows, double pixel);

  /// Values in the middles of a row's pixels: mean 0, variance 1, nearly normal.
  /// @param values  replaced, as many as columns
  void row(int number, std::span<float> values) const;

 private:
  using Grid = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  /// The first of three coefficients of a spline at a place, and their weights.
  struct Place {
    Eigen::Index first;
    std::array<float, 3> weights;
  };
  struct Octave {
    Grid coefficients;
    std::vector<Place> down, along;  // of rows and of columns
  };

  static std::vector<Place> places(int count, double step);

  std::vector<Octave> octaves_;
};

/// The noise as grey levels, 0 black, row by row from the upper left pixel: on average middle grey,
/// with a standard deviation of a fifth of the way from black to white.
/// @param columns, rows, pixel  as of WaveletNoise
std::vector<std::uint8_t> noise_levels(const ClothPattern& cloth, int columns, int rows,
                                       double pixel);

}  // namespace pliant
