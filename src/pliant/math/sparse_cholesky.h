#pragma once

#include <Eigen/SparseCholesky>

#include "pliant/math/linear_solver.h"

namespace pliant {

/// Sparse Cholesky factorisation after approximate minimum degree ordering; the symbolic analysis
/// is done once. A matrix that is not positive definite is noticed at the first pivot that shows
/// it.
class SparseCholesky : public LinearSolver {
 public:
  explicit SparseCholesky(const BlockMatrix& matrix);

  bool factorize(const BlockMatrix& matrix) override;
  LinearSummary solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const override;

 private:
  Eigen::SparseMatrix<double> lower_;
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
};

}  // namespace pliant
