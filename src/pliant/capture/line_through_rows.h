#pragma once

#include <vector>

namespace pliant {

/// A value between two rows of a table, and the slope there.
struct LinePiece {
  double value = 0, slope = 0;
};

/// On the lines from row to row, the first and the last of them prolonged.
/// @param at  increasing, two at least
LinePiece line_at(const std::vector<double>& at, const std::vector<double>& values, double place);

}  // namespace pliant
