#pragma once

#include <memory>

#include <Eigen/Core>

#include "pliant/math/block_matrix.h"

namespace pliant {

/// How a linear solve went.
struct LinearSummary {
  int iterations = 0;   ///< 0 for a direct solver
  double residual = 0;  ///< |K x - b| / |b| in the norm that the solver watches
  bool converged = true;
};

/// Solves K x = b with a symmetric positive definite block matrix K, again and again for matrices
/// of one pattern.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Takes the values of a matrix.
  /// @return whether the matrix was found positive definite; without it `solve` must not be called
  virtual bool factorize(const BlockMatrix& matrix) = 0;

  /// @param x  the starting guess of an iterative solver, then the solution
  virtual LinearSummary solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const = 0;

  /// Solutions for all columns of b.
  virtual Eigen::MatrixXd solve_all(const Eigen::MatrixXd& b) const = 0;

  /// A solver of the same kind for matrices of the same pattern, which shares what was found out
  /// about that; it has no factor yet.
  virtual std::unique_ptr<LinearSolver> another() const = 0;
};

}  // namespace pliant
