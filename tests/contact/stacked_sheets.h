#pragma once

#include <cmath>

#include <Eigen/Core>

#include "pliant/base/random.h"

namespace pliant::test {

/// Square sheets of triangles, one above the other.
struct Sheets {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi faces;
};

/// @param nodes  of each sheet along each side, 1 cm apart
/// @param apart  from sheet to sheet (m)
inline Sheets stacked_sheets(int sheets, int nodes, double apart) {
  constexpr double kEdge = 0.01;
  const int cells = nodes - 1;
  Sheets made{Eigen::Matrix3Xd(3, sheets * nodes * nodes),
              Eigen::Matrix3Xi(3, sheets * 2 * cells * cells)};
  int face = 0;
  for (int s = 0; s < sheets; ++s) {
    const auto number = [&](int i, int j) { return (s * nodes + j) * nodes + i; };
    for (int j = 0; j < nodes; ++j) {
      for (int i = 0; i < nodes; ++i) {
        // Each a little turned, so that no edge lies above another.
        const double angle = 0.3 * s, x = kEdge * (i - cells / 2.), y = kEdge * (j - cells / 2.);
        made.positions.col(number(i, j)) << std::cos(angle) * x - std::sin(angle) * y,
            std::sin(angle) * x + std::cos(angle) * y, apart * s;
        if (i == cells || j == cells) continue;
        made.faces.col(face++) << number(i, j), number(i + 1, j), number(i + 1, j + 1);
        made.faces.col(face++) << number(i, j), number(i + 1, j + 1), number(i, j + 1);
      }
    }
  }
  return made;
}

inline Eigen::Matrix3Xd random_ways(RandomStream& random, Eigen::Index count, double size) {
  Eigen::Matrix3Xd ways(3, count);
  for (double& x : ways.reshaped()) x = size * random.normal();
  return ways;
}

}  // namespace pliant::test
