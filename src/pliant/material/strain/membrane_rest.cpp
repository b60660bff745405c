#include "pliant/material/strain/membrane_rest.h"

#include <cmath>

#include <Eigen/LU>

#include "pliant/base/assert.h"

namespace pliant {

MembraneRest membrane_rest(const Eigen::Matrix<double, 2, 3>& corners) {
  Eigen::Matrix2d edges;
  edges << corners.col(1) - corners.col(0), corners.col(2) - corners.col(0);
  MembraneRest rest;
  rest.area = edges.determinant() / 2;
  PLIANT_ASSERT(rest.area > 0, "a rest triangle has a positive area: corners counter-clockwise");
  rest.weights.bottomRows<2>() = edges.inverse();
  rest.weights.row(0) = -rest.weights.row(1) - rest.weights.row(2);
  return rest;
}

Eigen::Matrix2d positive_part(const Eigen::Matrix2d& m) {
  const double mean = (m(0, 0) + m(1, 1)) / 2;
  const double spread = std::hypot((m(0, 0) - m(1, 1)) / 2, m(0, 1));
  if (mean >= spread) return m;
  if (mean <= -spread) return Eigen::Matrix2d::Zero();
  // One eigenvalue of each sign: keep the positive one, m - (mean - spread) I over 2 spread.
  const double high = mean + spread, low = mean - spread;
  return high / (2 * spread) * (m - low * Eigen::Matrix2d::Identity());
}

}  // namespace pliant
