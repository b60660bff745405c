#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/math/linear_solver.h"
#include "pliant/math/supernodes.h"

namespace pliant {

/// Sparse Cholesky factorisation after approximate minimum degree ordering; the symbolic analysis
/// is done once. A matrix that is not positive definite is noticed at the first pivot that shows
/// it.
///
/// Multifrontal: each supernode gathers its columns and what its children leave for them in a dense
/// front, factorises its columns and leaves the rest to its parent (Duff and Reid 1983). Dense
/// panels take several times as many operations a second as single columns do.
class SparseCholesky : public LinearSolver {
 public:
  explicit SparseCholesky(const BlockMatrix& matrix);

  bool factorize(const BlockMatrix& matrix) override;
  LinearSummary solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const override;
  /// Solutions for all columns of b.
  Eigen::MatrixXd solve_all(const Eigen::MatrixXd& b) const;

 private:
  /// A block of the matrix in the front of a supernode.
  struct Entry {
    int block = 0, row = 0, column = 0;  // of the matrix; block row and column of the front
    bool transposed = false;
  };

  void gather(const BlockMatrix& matrix, std::size_t node, Eigen::MatrixXd& front);
  void substitute(Eigen::MatrixXd& x) const;

  SymbolicFactor symbolic_;
  std::vector<std::vector<Entry>> entries_;    // of each supernode
  std::vector<std::vector<int>> children_;     // of each supernode
  std::vector<std::vector<int>> parent_rows_;  // in the parent's front, of each of `rows`
  std::vector<Eigen::MatrixXd> panels_;        // the factor's columns
  std::vector<Eigen::MatrixXd> left_;          // for the parent; empty once it has taken it
};

}  // namespace pliant
