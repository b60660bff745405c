#include "pliant/material/strain/membrane_rest.h"

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

}  // namespace pliant
