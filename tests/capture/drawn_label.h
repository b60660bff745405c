#pragma once

#include "pliant/capture/tag_detector.h"
#include "pliant/capture/view_drawing.h"

namespace pliant::test {

inline constexpr double kDrawnTag = 8e-3;  ///< side of a drawn label's black square (m)

/// A label of that middle on white paper, 0.2 mm high, moved.
inline DrawnSurface drawn_label(int code, const Eigen::Vector2d& middle,
                                const Eigen::Vector3d& moved = Eigen::Vector3d::Zero()) {
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(kDrawnTag / 2);
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(2e-3);
  DrawnSurface paper = flat_rectangle(
      {middle - half - margin, middle + half + margin}, 0.2e-3,
      [cells = tag_cells(code), from = Eigen::Vector2d(middle - half)](const Eigen::Vector2d& at) {
        const Eigen::Vector2d place = (at - from) / kDrawnTag;
        if (place.minCoeff() < 0 || place.maxCoeff() >= 1) return 0.9;
        return 0.1 + 0.8 * static_cast<double>(cells(static_cast<int>((1 - place.y()) * 8),
                                                     static_cast<int>(place.x() * 8)));
      });
  paper.positions.colwise() += moved;
  return paper;
}

}  // namespace pliant::test
