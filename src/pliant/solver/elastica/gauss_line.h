#pragma once

#include <Eigen/Core>

namespace pliant {

/// Functions on a line of some length, given by their values at Gauss points: polynomials element
/// by element, whose integrals are exact.
class GaussLine {
 public:
  /// @param length    > 0 (m)
  /// @param elements  of equal length
  GaussLine(double length, int elements);

  int size() const { return static_cast<int>(places_.size()); }
  double length() const { return length_; }
  /// Distances of the points from the start (m), ascending.
  const Eigen::VectorXd& places() const { return places_; }
  /// Integral of a function over the line = weights . values.
  const Eigen::VectorXd& weights() const { return weights_; }
  /// Row i . values = integral from the start to point i.
  const Eigen::MatrixXd& integration() const { return integration_; }

  /// integration^T diag(factors) integration, at the cost of its entries.
  Eigen::MatrixXd integration_gram(const Eigen::VectorXd& factors) const;

  /// Integral from the start to `place` = these weights . values.
  /// @param place  0 <= place <= length
  Eigen::RowVectorXd integral_weights(double place) const;
  /// Value at `place` = these weights . values.
  Eigen::RowVectorXd value_weights(double place) const;

 private:
  int element_at(double place) const;
  /// Place in an element, from -1 to 1.
  double local(int element, double place) const;

  double length_ = 0;
  int elements_ = 0;
  Eigen::VectorXd places_, weights_;
  Eigen::MatrixXd integration_;
};

}  // namespace pliant
