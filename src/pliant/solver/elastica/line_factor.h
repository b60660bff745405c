#pragma once

#include <vector>

#include <Eigen/Cholesky>

#include "pliant/solver/elastica/gauss_line.h"

namespace pliant {

/// diag(bending) + integration^T diag(turning) integration on a line: the matrix of an energy of
/// curvatures and of the angles that they add up to.
///
/// What lies behind an element sees nothing of it but the angle at its end, so that elements are
/// eliminated one by one from the free end: the cost grows with their number alone.
class LineFactor {
 public:
  LineFactor(const GaussLine& line, const Eigen::VectorXd& bending, const Eigen::VectorXd& turning);

  bool is_positive() const { return positive_; }
  /// Needs a matrix that is positive.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

 private:
  struct Element {
    Eigen::LLT<GaussLine::Block> own;
    GaussLine::Values by_angle;  // own gradient by the angle at the element's start
    GaussLine::Values response;  // of the curvatures to that angle
  };

  GaussLine::Values weights_;
  std::vector<Element> elements_;
  bool positive_ = true;
};

}  // namespace pliant
