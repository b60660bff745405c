#pragma once

#include <array>
#include <vector>

#include "pliant/math/block_matrix.h"

namespace pliant {

/// The rows of a symmetric matrix in an order for Gauss-Seidel sweeps that two may make at once:
/// the first half from its beginning, the second from its end, then what is between them. The
/// halves are not coupled. Both ways lead to the middle, so that a sweep carries as far as one
/// through all rows and conjugate gradients take as many iterations (orders with more places where
/// sweeps begin take up to twice as many).
struct RowParts {
  std::vector<int> rows;          ///< half by half, then those of the middle
  std::array<int, 4> begin = {};  ///< of the three parts in `rows`, and the end

  static constexpr int kHalves = 2, kMiddle = 2;
};

/// Cuts in the middle of the given order where that leaves few rows between the halves, else
/// nowhere: all rows are then in the first half.
RowParts row_parts(const BlockPattern& pattern);

}  // namespace pliant
