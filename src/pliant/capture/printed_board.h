#pragma once

#include <vector>

#include "pliant/capture/pattern.h"
#include "pliant/capture/spline_picture.h"
#include "pliant/capture/view_drawing.h"

namespace pliant {

/// A board of tags on white paper, as it was printed.
class PrintedBoard {
 public:
  explicit PrintedBoard(const TagBoard& board);

  /// Brightness of a place in the board's axes (m): 1 where white, 0 where black.
  double at(const Eigen::Vector2d& place) const;

 private:
  TagBoard board_;
  std::vector<GreyPicture> cells_;
};

/// The board as a surface in its own axes, with a gap of white around.
/// @param dark, bright  brightness of ink and paper
DrawnSurface board_surface(const TagBoard& board, double dark = 0.1, double bright = 0.9);

/// A label: a tag, upright along the axes.
/// @param side            of its black square (m)
/// @param margin          of white around it (m)
/// @param middle, height  where it lies (m)
DrawnSurface label_surface(int code, double side, double margin, const Eigen::Vector2d& middle,
                           double height);

}  // namespace pliant
