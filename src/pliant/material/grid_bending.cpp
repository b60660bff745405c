#include "pliant/material/grid_bending.h"

#include <vector>

namespace pliant {
namespace {

// The hinges of one kind in a cell. Their dihedral angle over their mean height is linear in the
// mean curvatures (uu, vv, uv) and in the offset, the height between the two kinds of vertices
// (times 2 over the area of a rectangle, so that it is a curvature too).
struct CellHinge {
  int component = 0;
  double area = 1;  // three times the fraction of the sheet that belongs to these hinges
  Eigen::Vector3d by_curvature;
  double by_offset = 0;
};

// The angles follow from the heights of a quadratic surface and of the offset at the four vertices
// of each hinge.
std::vector<CellHinge> cell_hinges(const GridPattern& pattern) {
  const double slope = pattern.side_v / pattern.side_u;
  const double twist = slope + 1 / slope;
  if (pattern.diagonals == Diagonals::alternating) {
    return {{0, 1, {1, 0, 0}, slope},
            {1, 1, {0, 1, 0}, 1 / slope},
            {2, 0.5, {0, 0, twist}, twist},
            {2, 0.5, {0, 0, -twist}, twist}};
  }
  const double sign = pattern.diagonals == Diagonals::rising ? 1 : -1;
  return {
      {0, 1, {1, 0, sign * slope}, 0}, {1, 1, {0, 1, sign / slope}, 0}, {2, 1, {0, 0, twist}, 0}};
}

// The offset of least energy.
double relaxed_offset(const std::vector<CellHinge>& hinges, const BendingVector& stiffness,
                      const Eigen::Vector3d& curvature) {
  double force = 0, resistance = 0;
  for (const CellHinge& hinge : hinges) {
    const double weight = hinge.area * stiffness(hinge.component) * hinge.by_offset;
    force -= weight * hinge.by_curvature.dot(curvature);
    resistance += weight * hinge.by_offset;
  }
  return resistance > 0 ? force / resistance : 0;
}

}  // namespace

RigidityShares grid_rigidity(const GridPattern& pattern, const BendingVector& hinge_stiffness) {
  const std::vector<CellHinge> hinges = cell_hinges(pattern);
  const auto curvatures = cylinder_curvatures();
  RigidityShares shares = RigidityShares::Zero();
  for (int direction = 0; direction < shares.rows(); ++direction) {
    const Eigen::Vector3d curvature = curvatures.row(direction);
    const double offset = relaxed_offset(hinges, hinge_stiffness, curvature);
    for (const CellHinge& hinge : hinges) {
      const double bend = hinge.by_curvature.dot(curvature) + hinge.by_offset * offset;
      shares(direction, hinge.component) += hinge.area * bend * bend;
    }
  }
  return shares;
}

}  // namespace pliant
