#include "pliant/capture/printed_board.h"

#include <cmath>
#include <memory>

#include "pliant/capture/tag_detector.h"

namespace pliant {

PrintedBoard::PrintedBoard(const TagBoard& board) : board_(board) {
  for (int i = 0; i < board.tag_count(); ++i) cells_.push_back(tag_cells(board.first_code + i));
}

double PrintedBoard::at(const Eigen::Vector2d& place) const {
  const double step = board_.tag + board_.gap;
  const int column = static_cast<int>(std::floor(place.x() / step));
  const int row_up = static_cast<int>(std::floor(place.y() / step));
  if (column < 0 || row_up < 0 || column >= board_.columns || row_up >= board_.rows) return 1;
  const Eigen::Vector2d within =
      (place - step * Eigen::Vector2d(column, row_up)) / board_.tag * kTagCells;
  if (within.maxCoeff() >= kTagCells) return 1;
  const int number = (board_.rows - 1 - row_up) * board_.columns + column;
  const GreyPicture& cells = cells_[static_cast<std::size_t>(number)];
  return cells(kTagCells - 1 - static_cast<int>(within.y()), static_cast<int>(within.x()));
}

DrawnSurface board_surface(const TagBoard& board, double dark, double bright) {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(board.gap);
  const auto printed = std::make_shared<const PrintedBoard>(board);
  return flat_rectangle({-margin, board.extent() + margin}, 0,
                        [printed, dark, bright](const Eigen::Vector2d& place) {
                          return dark + (bright - dark) * printed->at(place);
                        });
}

DrawnSurface label_surface(int code, double side, double margin, const Eigen::Vector2d& middle,
                           double height) {
  DrawnSurface surface = board_surface(TagBoard{1, 1, side, margin, code});
  surface.positions.topRows<2>().colwise() += middle - Eigen::Vector2d::Constant(side / 2);
  surface.positions.row(2).setConstant(height);
  return surface;
}

}  // namespace pliant
