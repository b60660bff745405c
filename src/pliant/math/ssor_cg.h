#pragma once

#include <memory>
#include <vector>

#include "pliant/math/linear_solver.h"

namespace pliant {

class SsorMatrix;

/// Conjugate gradients with a symmetric Gauss-Seidel preconditioner in Eisenstat's form (SIAM J.
/// Sci. Stat. Comput. 2 (1981) 1): the preconditioned product costs no more than a plain one.
///
/// The matrix is scaled to unit diagonal blocks and kept in single precision, half of it: at the
/// sizes of a cloth in motion the solve is bound by memory. A residual below about 1e-4 is reached
/// by refinement: the true residual is formed in double precision and solved for again.
class SsorCg : public LinearSolver {
 public:
  struct Options {
    double tolerance = 1e-4;  ///< of the residual in the preconditioner's norm, relative to b
    int max_iterations = 2000;
  };

  SsorCg(const BlockMatrix& matrix, const Options& options);
  ~SsorCg() override;

  /// Notices a diagonal block that is not positive definite, not more; `solve` notices the rest.
  bool factorize(const BlockMatrix& matrix) override;
  LinearSummary solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const override;
  Eigen::MatrixXd solve_all(const Eigen::MatrixXd& b) const override;
  std::unique_ptr<LinearSolver> another() const override;

 private:
  Options options_;
  const BlockMatrix* matrix_;
  std::unique_ptr<SsorMatrix> scaled_;
};

}  // namespace pliant
