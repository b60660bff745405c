#include "pliant/geometry/hinge_direction.h"

#include <cmath>
#include <numbers>

#include "pliant/geometry/grid_pattern.h"

namespace pliant {
namespace {

// Coordinates in files are rounded; the diagonal of a rectangle is never as near to a side.
constexpr double kParallel = 1e-3;

}  // namespace

double curvature_angle(const Eigen::Vector2d& rest_edge) {
  return std::atan2(std::abs(rest_edge.x()), std::abs(rest_edge.y()));
}

BendingVector class_weights(double curvature_angle) {
  if (curvature_angle < kParallel) return BendingVector::UnitX();
  if (curvature_angle > std::numbers::pi / 2 - kParallel) return BendingVector::UnitY();
  return BendingVector::UnitZ();
}

BendingVector interpolated_weights(double curvature_angle) {
  const double c = std::cos(2 * curvature_angle), axis = c * c;
  return c > 0 ? BendingVector(axis, 0, 1 - axis) : BendingVector(0, axis, 1 - axis);
}

BendingRule bending_rule(const TriangleMesh& mesh) {
  return is_cut_from_rectangles(mesh) ? BendingRule::by_class : BendingRule::interpolated;
}

std::vector<BendingVector> bending_weights(const std::vector<Hinge>& hinges, BendingRule rule) {
  std::vector<BendingVector> weights;
  weights.reserve(hinges.size());
  for (const Hinge& hinge : hinges) {
    const double angle = curvature_angle(hinge.rest_edge);
    weights.push_back(rule == BendingRule::by_class ? class_weights(angle)
                                                    : interpolated_weights(angle));
  }
  return weights;
}

}  // namespace pliant
