#include "pliant/math/gaussian_weights.h"

namespace pliant {

Eigen::VectorXd gaussian_weights(const Eigen::VectorXd& squares, double width) {
  if (squares.size() == 1) return Eigen::VectorXd::Ones(1);
  // What is far away counts nothing, rather than next to nothing.
  constexpr double kNothing = 1e-9;
  const double least = squares.minCoeff();
  Eigen::VectorXd weights = (-(squares.array() - least) / (2 * width * width)).exp().matrix();
  weights = (weights.array() < kNothing).select(0, weights);
  return weights / weights.sum();
}

}  // namespace pliant
