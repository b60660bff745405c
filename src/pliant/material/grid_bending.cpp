#include "pliant/material/grid_bending.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/material/bending_strain.h"
#include "pliant/math/root.h"

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

// The offset at which the moments of all hinges balance.
double balanced_offset(const std::vector<CellHinge>& hinges, const HingeStress& stress,
                       const Eigen::Vector3d& curvature) {
  // Beyond the largest offset at which a hinge is flat all of them push back.
  double reach = 0;
  for (const CellHinge& hinge : hinges) {
    if (hinge.by_offset == 0) continue;
    reach = std::max(reach, std::abs(hinge.by_curvature.dot(curvature) / hinge.by_offset));
  }
  if (reach == 0) return 0;
  const auto force = [&](double offset) {
    double sum = 0;
    for (const CellHinge& hinge : hinges) {
      const double bend = hinge.by_curvature.dot(curvature) + hinge.by_offset * offset;
      sum += hinge.area * hinge.by_offset * stress(hinge.component, kStrainPerCurvature * bend);
    }
    return sum;
  };
  return root_in_bracket(force, -reach, reach);
}

// @param offset_of  the offset of a sheet of given curvatures
std::vector<BentHinge> bent(const std::vector<CellHinge>& hinges, double curvature,
                            const std::function<double(const Eigen::Vector3d&)>& offset_of) {
  const auto cylinders = cylinder_curvatures();
  Eigen::RowVector4d offsets;
  for (int direction = 0; direction < offsets.size(); ++direction) {
    offsets(direction) = offset_of(curvature * cylinders.row(direction)) / curvature;
  }
  std::vector<BentHinge> result;
  for (const CellHinge& hinge : hinges) {
    const Eigen::RowVector4d bends =
        (cylinders * hinge.by_curvature).transpose() + hinge.by_offset * offsets;
    result.push_back({BendingVector::Unit(hinge.component), hinge.area, bends});
  }
  return result;
}

}  // namespace

RigidityShares grid_rigidity(const GridPattern& pattern, const BendingVector& hinge_stiffness) {
  const std::vector<CellHinge> hinges = cell_hinges(pattern);
  return rigidity_shares(bent(hinges, 1, [&](const Eigen::Vector3d& curvature) {
    return relaxed_offset(hinges, hinge_stiffness, curvature);
  }));
}

std::vector<BentHinge> bent_cell(const GridPattern& pattern, const HingeStress& stress,
                                 double curvature) {
  const std::vector<CellHinge> hinges = cell_hinges(pattern);
  return bent(hinges, curvature,
              [&](const Eigen::Vector3d& sheet) { return balanced_offset(hinges, stress, sheet); });
}

}  // namespace pliant
