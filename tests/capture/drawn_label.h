#pragma once

#include "pliant/capture/printed_board.h"

namespace pliant::test {

inline constexpr double kDrawnTag = 8e-3;  ///< side of a drawn label's black square (m)

/// A label of that middle on white paper, 0.2 mm high, moved.
inline DrawnSurface drawn_label(int code, const Eigen::Vector2d& middle,
                                const Eigen::Vector3d& moved = Eigen::Vector3d::Zero()) {
  DrawnSurface paper = label_surface(code, kDrawnTag, 2e-3, middle, 0.2e-3);
  paper.positions.colwise() += moved;
  return paper;
}

}  // namespace pliant::test
