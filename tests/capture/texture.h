#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "pliant/base/random.h"
#include "pliant/capture/patch_tracker.h"
#include "pliant/capture/spline_picture.h"

namespace pliant::test {

/// A picture of a brightness that is known everywhere.
inline GreyPicture drawn(int columns, int rows,
                         const std::function<double(const Eigen::Vector2d&)>& at) {
  GreyPicture picture(rows, columns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      picture(row, column) = static_cast<float>(at(Eigen::Vector2d(column, row)));
    }
  }
  return picture;
}

/// A texture in closed form, which can be seen wherever it has moved to without interpolation:
/// waves of six pixels and more in all directions. Its brightness is about 128 +- 40.
class Texture {
 public:
  explicit Texture(std::uint64_t seed) {
    RandomStream random(seed);
    for (int i = 0; i < 40; ++i) {
      const double length = random.uniform(6, 25), angle = random.uniform(0, std::numbers::pi);
      const double wave = 2 * std::numbers::pi / length;
      waves_.push_back({{wave * std::cos(angle), wave * std::sin(angle)},
                        random.uniform(0, 2 * std::numbers::pi)});
    }
  }

  double at(const Eigen::Vector2d& place) const {
    double sum = 0;
    for (const Wave& wave : waves_) sum += std::cos(wave.vector.dot(place) + wave.phase);
    return 128 + 40 * sum / std::sqrt(static_cast<double>(waves_.size()) / 2);
  }

  /// What is seen at each pixel.
  /// @param from  the place of the texture that is there
  GreyPicture picture(int columns, int rows,
                      const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& from) const {
    return drawn(columns, rows, [&](const Eigen::Vector2d& place) { return at(from(place)); });
  }

 private:
  struct Wave {
    Eigen::Vector2d vector;
    double phase;
  };
  std::vector<Wave> waves_;
};

/// Threads over and under each other, as bright; it is the same again a thread to the right and one
/// down.
/// @param apart  pixels from thread to thread
inline double weave_at(const Eigen::Vector2d& place, double apart) {
  const double wave = std::numbers::pi / apart;
  return 128 + 60 * std::sin(wave * place.x()) * std::sin(wave * place.y());
}

inline void add_noise(GreyPicture& picture, double sd, RandomStream& random) {
  for (float& pixel : picture.reshaped()) pixel += static_cast<float>(sd * random.normal());
}

/// Patches every ten pixels of both ways.
inline void add_patches(PatchTracker& tracker, int from, int to) {
  for (int y = from; y <= to; y += 10) {
    for (int x = from; x <= to; x += 10) tracker.add({x, y});
  }
}

}  // namespace pliant::test
