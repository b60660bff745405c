#include "pliant/capture/wavelet_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

using Line = Eigen::ArrayXd;  // that goes round

/// A grid step in finest lengths.
constexpr double kStep = 2.0 / 3.0;
/// Standard deviation of one octave, of coefficients of variance 1 before the coarse part is taken
/// away.
constexpr double kOctaveDeviation = 0.367;
/// Middle grey and contrast: 1 value in 80 is cut at black or white.
constexpr double kMeanLevel = 127.5, kLevelDeviation = 51;

Eigen::Index around(Eigen::Index i, Eigen::Index count) { return ((i % count) + count) % count; }

/// Inner products of a spline with the splines of its grid: (1, 26, 66, 26, 1) / 120.
Line gram(const Line& line) {
  const Eigen::Index n = line.size();
  Line result(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = [&](Eigen::Index by) { return line(around(i + by, n)); };
    result(i) = (at(-2) + 26 * at(-1) + 66 * at(0) + 26 * at(1) + at(2)) / 120;
  }
  return result;
}

/// One factor of the inverse of `gram`, 1 / ((1 - z/q) (1 - z q)) but for a constant, by a
/// recursion there and back, whose start is told by one round before.
void divide_by_pole(double z, Line& line) {
  const Eigen::Index n = line.size();
  constexpr Eigen::Index kForgets = 48;  // z^48 is below rounding
  double last = 0;
  for (Eigen::Index i = -kForgets; i < 0; ++i) last = line(around(i, n)) + z * last;
  for (Eigen::Index i = 0; i < n; ++i) last = line(i) += z * last;
  last = 0;
  for (Eigen::Index i = kForgets; i-- > 0;) last = line(around(i, n)) + z * last;
  for (Eigen::Index i = n; i-- > 0;) last = line(i) += z * last;
  line *= (1 - z) * (1 - z);
}

void divide_by_gram(Line& line) {
  for (const double s : {-13 + std::sqrt(105.0), -13 - std::sqrt(105.0)}) {  // z + 1/z
    divide_by_pole((s + std::sqrt(s * s - 4)) / 2, line);
  }
}

/// A spline of a grid twice as coarse, on the finer grid: (1, 3, 3, 1) / 4.
constexpr std::array kTwoScale{0.25, 0.75, 0.75, 0.25};

/// The spline on a grid twice as coarse that is nearest to a spline, by its coefficients on the
/// finer grid.
/// @param line  an even number of coefficients
void keep_coarse_part(Line& line) {
  const Eigen::Index n = line.size();
  const Line products = gram(line);
  Line coarse = Line::Zero(n / 2);
  for (Eigen::Index j = 0; j < n / 2; ++j) {
    for (Eigen::Index k = 0; k < 4; ++k) {
      coarse(j) += kTwoScale[k] * products(around(2 * j + k - 1, n)) / 2;
    }
  }
  divide_by_gram(coarse);
  line.setZero();
  for (Eigen::Index j = 0; j < n / 2; ++j) {
    for (Eigen::Index k = 0; k < 4; ++k) {
      line(around(2 * j + k - 1, n)) += kTwoScale[k] * coarse(j);
    }
  }
}

Eigen::ArrayXXd random_octave(Eigen::Index rows, Eigen::Index columns, RandomStream random) {
  Eigen::ArrayXXd grid(rows, columns);
  for (Eigen::Index r = 0; r < rows; ++r) {
    for (Eigen::Index c = 0; c < columns; ++c) grid(r, c) = random.normal();
  }
  Eigen::ArrayXXd coarse = grid;
  Line line;
  for (Eigen::Index c = 0; c < columns; ++c) {
    line = coarse.col(c);
    keep_coarse_part(line);
    coarse.col(c) = line;
  }
  for (Eigen::Index r = 0; r < rows; ++r) {
    line = coarse.row(r).transpose();
    keep_coarse_part(line);
    coarse.row(r) = line.transpose();
  }
  return (grid - coarse) / kOctaveDeviation;
}

/// Of a grid that is as long as `count` pixels and a spline at both ends: an even number.
Eigen::Index grid_size(int count, double pixels_a_step) {
  constexpr Eigen::Index kSpare = 4;
  return 2 * ((static_cast<Eigen::Index>(count / pixels_a_step) + kSpare + 1) / 2);
}

}  // namespace

WaveletNoise::WaveletNoise(const ClothPattern& cloth, int columns, int rows, double pixel) {
  const RandomStream random(cloth.seed);
  double step = kStep * cloth.finest / pixel, power = 1, sum = 0;
  for (int i = 0; i < cloth.octaves; ++i) {
    const Eigen::Index down = grid_size(rows, step), along = grid_size(columns, step);
    Grid grid = random_octave(down, along, random.split(fmt::format("octave {}", i))).cast<float>();
    grid *= static_cast<float>(std::sqrt(power));
    octaves_.push_back({std::move(grid), places(rows, step), places(columns, step)});
    sum += power;
    power /= 2;
    step *= 2;
  }
  for (Octave& octave : octaves_) octave.coefficients /= static_cast<float>(std::sqrt(sum));
}

std::vector<WaveletNoise::Place> WaveletNoise::places(int count, double step) {
  std::vector<Place> places;
  for (int i = 0; i < count; ++i) {
    const double place = (i + 0.5) / step, middle = std::round(place), t = place - middle;
    const double left = (0.5 - t) * (0.5 - t) / 2, right = (0.5 + t) * (0.5 + t) / 2;
    places.push_back({static_cast<Eigen::Index>(middle),
                      {static_cast<float>(left), static_cast<float>(1 - left - right),
                       static_cast<float>(right)}});
  }
  return places;
}

void WaveletNoise::row(int number, std::span<float> values) const {
  std::ranges::fill(values, 0.0F);
  Eigen::ArrayXf line;
  for (const Octave& octave : octaves_) {
    const Place& down = octave.down.at(number);
    line.setZero(octave.coefficients.cols());
    for (Eigen::Index k = 0; k < 3; ++k) {
      line += down.weights[k] * octave.coefficients.row(down.first + k).transpose();
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Place& along = octave.along[i];
      const float* const at = line.data() + along.first;
      values[i] += along.weights[0] * at[0] + along.weights[1] * at[1] + along.weights[2] * at[2];
    }
  }
}

std::vector<std::uint8_t> noise_levels(const ClothPattern& cloth, int columns, int rows,
                                       double pixel) {
  const WaveletNoise noise(cloth, columns, rows, pixel);
  std::vector<std::uint8_t> levels(static_cast<std::size_t>(columns) * rows);
  std::vector<float> values(columns);
  auto level = levels.begin();
  for (int r = 0; r < rows; ++r) {
    noise.row(r, values);
    for (const float value : values) {
      const double grey = std::clamp(kMeanLevel + kLevelDeviation * value, 0.0, 255.0);
      *level++ = static_cast<std::uint8_t>(std::lround(grey));
    }
  }
  return levels;
}

}  // namespace pliant
