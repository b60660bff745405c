#include "pliant/mechanics/shape_difference.h"

#include <cmath>
#include <numbers>

#include "pliant/base/assert.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/mechanics/cloth_potentials.h"

namespace pliant {
namespace {

double angle_of(const Hinge& hinge, const Eigen::Matrix3Xd& positions) {
  DiscreteShells::Positions corners;
  for (int k = 0; k < 4; ++k) corners.col(k) = positions.col(hinge.vertices[k]);
  return dihedral_angle(corners);
}

}  // namespace

ShapeComparison::ShapeComparison(const TriangleMesh& mesh)
    : areas_(vertex_areas(mesh)), hinges_(find_hinges(mesh)) {}

ShapeDifference ShapeComparison::operator()(const Eigen::Matrix3Xd& one,
                                            const Eigen::Matrix3Xd& other) const {
  PLIANT_ASSERT(one.cols() == areas_.size() && other.cols() == areas_.size(),
                "both shapes have the vertices of the mesh");
  const Eigen::VectorXd squares = (one - other).colwise().squaredNorm();
  ShapeDifference difference;
  difference.distance = std::sqrt(squares.dot(areas_) / areas_.sum());
  difference.largest_distance = std::sqrt(squares.maxCoeff());
  double sum = 0, area = 0;
  for (const Hinge& hinge : hinges_) {
    // A hinge that is folded over may be told as either side of half a turn.
    const double turn =
        std::remainder(angle_of(hinge, one) - angle_of(hinge, other), 2 * std::numbers::pi);
    sum += hinge.area * std::pow(turn / hinge.height, 2);
    area += hinge.area;
  }
  if (area > 0) difference.curvature = std::sqrt(sum / area);
  return difference;
}

}  // namespace pliant
