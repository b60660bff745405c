#include "pliant/capture/pattern.h"

#include <algorithm>

#include "pliant/base/assert.h"

namespace pliant {

std::array<Eigen::Vector3d, 4> TagBoard::corners(int code) const {
  PLIANT_ASSERT(has(code), "a code of this board");
  const int number = code - first_code;
  const double step = tag + gap;
  const double left = step * (number % columns), low = step * (rows - 1 - number / columns);
  return {Eigen::Vector3d(left, low, 0), Eigen::Vector3d(left + tag, low, 0),
          Eigen::Vector3d(left + tag, low + tag, 0), Eigen::Vector3d(left, low + tag, 0)};
}

Eigen::Vector2d TagBoard::extent() const {
  return {columns * (tag + gap) - gap, rows * (tag + gap) - gap};
}

Eigen::Vector3d Chessboard::corner(int number) const {
  PLIANT_ASSERT(number >= 0 && number < corner_count(), "a corner of this board");
  return {square * (number % columns), square * (rows - 1 - number / columns), 0};
}

Eigen::Vector2d Chessboard::extent() const { return {square * (columns + 1), square * (rows + 1)}; }

bool ClipCodes::has(int code) const { return std::ranges::find(codes, code) != codes.end(); }

}  // namespace pliant
