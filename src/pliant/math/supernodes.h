#pragma once

#include <vector>

#include "pliant/math/block_matrix.h"

namespace pliant {

/// Neighbouring block columns of a Cholesky factor that have the same rows below them, so that they
/// are factorised as one dense panel. Rows and columns are counted in the order of elimination.
struct Supernode {
  int first = 0;          ///< column
  int columns = 0;        ///< 1 or more
  std::vector<int> rows;  ///< below the columns, increasing
  int parent = -1;        ///< the supernode that its rows begin in; -1 where it has none

  /// Block rows of its dense front: the columns' own, then `rows`.
  int size() const { return columns + static_cast<int>(rows.size()); }
};

/// What the Cholesky factors of all matrices of a pattern have in common.
struct SymbolicFactor {
  std::vector<int> place;             ///< of each block row of the matrix in the elimination
  std::vector<Supernode> supernodes;  ///< children before their parents

  /// Approximate minimum degree ordering, elimination tree and its supernodes. Supernodes that
  /// share almost all of their rows are one: a few zeros cost less than a small panel.
  explicit SymbolicFactor(const BlockPattern& pattern);
};

}  // namespace pliant
