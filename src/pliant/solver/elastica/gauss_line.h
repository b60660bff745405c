#pragma once

#include <Eigen/Core>

namespace pliant {

/// Functions on a line of some length, given by their values at Gauss points: polynomials element
/// by element, whose integrals are exact.
class GaussLine {
 public:
  static constexpr int kOrder = 6;  ///< Gauss points of an element
  using Values = Eigen::Matrix<double, kOrder, 1>;
  using Block = Eigen::Matrix<double, kOrder, kOrder>;

  /// @param length    > 0 (m)
  /// @param elements  of equal length
  GaussLine(double length, int elements);

  int size() const { return static_cast<int>(places_.size()); }
  int elements() const { return elements_; }
  double length() const { return length_; }
  /// Distances of the points from the start (m), ascending.
  const Eigen::VectorXd& places() const { return places_; }
  /// Integral of a function over the line = weights . values.
  const Eigen::VectorXd& weights() const { return weights_; }
  /// The same of one element: all are alike.
  Values element_weights() const { return weights_.head<kOrder>(); }
  /// Row i . values = integral from an element's start to its point i.
  const Block& element_integration() const { return element_integration_; }

  /// Integrals from the start to the points, of a function a column.
  Eigen::MatrixXd integrals(const Eigen::MatrixXd& values) const;
  /// The transposed of that map.
  Eigen::VectorXd transposed_integrals(const Eigen::VectorXd& values) const;
  /// integration^T diag(factors) integration, where integration is the map of `integrals`.
  Eigen::MatrixXd integration_gram(const Eigen::VectorXd& factors) const;

  /// What a place makes of the values in its element, `first` being that of its first point.
  struct Local {
    int first;
    Eigen::Matrix<double, 1, kOrder> integral;  ///< weights, from the element's start
    Eigen::Matrix<double, 1, kOrder> value;     ///< weights
  };
  /// @param place  0 <= place <= length
  Local at(double place) const;

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
  Block element_integration_;
};

}  // namespace pliant
