#include "pliant/math/sparse_cholesky.h"

namespace pliant {

SparseCholesky::SparseCholesky(const BlockMatrix& matrix) : lower_(matrix.lower_triangle()) {
  factor_.analyzePattern(lower_);
}

bool SparseCholesky::factorize(const BlockMatrix& matrix) {
  if (lower_.rows() == 0) return true;
  matrix.copy_to(lower_);
  // A pivot that is not a number would pass for positive.
  if (!lower_.coeffs().allFinite()) return false;
  factor_.factorize(lower_);
  return factor_.info() == Eigen::Success;
}

LinearSummary SparseCholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  x = b.size() == 0 ? b : Eigen::VectorXd(factor_.solve(b));
  return {};
}

}  // namespace pliant
