#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "pliant/math/linear_solver.h"

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
  ~SparseCholesky() override;

  bool factorize(const BlockMatrix& matrix) override;
  LinearSummary solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const override;
  Eigen::MatrixXd solve_all(const Eigen::MatrixXd& b) const override;
  std::unique_ptr<LinearSolver> another() const override;

 private:
  struct Analysis;  // of the pattern: constant, and shared

  explicit SparseCholesky(std::shared_ptr<const Analysis> analysis);
  Eigen::VectorXd gather(const BlockMatrix& matrix, std::size_t node, Eigen::MatrixXd& front);
  void substitute(Eigen::MatrixXd& x) const;

  std::shared_ptr<const Analysis> analysis_;
  std::vector<Eigen::MatrixXd> panels_;  // of each supernode: the factor's columns
  std::vector<Eigen::MatrixXd> left_;    // for the parent; empty once it has taken it
};

}  // namespace pliant
