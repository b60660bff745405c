#include "pliant/material/strain/linear_tetrahedron.h"

#include "pliant/base/assert.h"

namespace pliant {
namespace {

Eigen::Matrix3d edges_of(const LinearTetrahedron::Positions& positions) {
  return positions.rightCols<3>().colwise() - positions.col(0);
}

}  // namespace

LinearTetrahedron::Rest tetrahedron_rest(const LinearTetrahedron::Positions& rest_positions) {
  const Eigen::Matrix3d edges = edges_of(rest_positions);
  PLIANT_ASSERT(edges.determinant() > 0, "a tetrahedron has a volume at rest");
  LinearTetrahedron::Rest rest;
  rest.weights.bottomRows<3>() = edges.inverse();
  rest.weights.row(0) = -rest.weights.bottomRows<3>().colwise().sum();
  return rest;
}

double tetrahedron_volume(const LinearTetrahedron::Positions& positions) {
  return edges_of(positions).determinant() / 6;
}

}  // namespace pliant
