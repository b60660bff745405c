#pragma once

#include <array>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/hinge_direction.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/material/component_law.h"

namespace pliant::test {

/// Laws of hinges in the order weft, warp, diagonal.
using HingeLaws = std::array<ComponentLaw, 3>;

/// What was lost on a closed loop of curvature, and the loop that the sheet went through: its rim
/// does not relax, which leaves its inside another curvature than was imposed.
struct Loop {
  double loss = 0;       ///< J/m^2
  double curvature = 0;  ///< 1/m
};

/// A sheet of hinges as a linear plate, of small heights over its rest plane, whose vertices come
/// to equilibrium at each step of curvature that is imposed on it.
class RolledPlate {
 public:
  /// A large sheet of a regular pattern of squares, by what repeats of it.
  static RolledPlate periodic(Diagonals diagonals);
  /// Held at its rim, looked at inside.
  static RolledPlate piece(const TriangleMesh& mesh);

  /// From flat to a cylinder, to its mirror image and back.
  /// @param direction  of the curvature, from weft (degrees)
  /// @param steps      of each half of the loop
  Loop roll(const HingeLaws& laws, double curvature, double direction, int steps) const;

 private:
  struct PlateHinge {
    BendingVector parts;
    double area = 0, shown = 0;  // three times: of the hinge; of its part inside, a fraction of it
    Eigen::RowVector3d by_curvature;
    std::vector<std::pair<int, double>> by_unknown;
  };
  class Rolling;

  void add_hinges(const TriangleMesh& mesh, const std::vector<int>& unknown_of_vertex,
                  const std::vector<double>& shown_of_triangle);

  std::vector<PlateHinge> hinges_;
  int unknowns_ = 0;
};

/// What a sheet's own law loses on the same loop (J/m^2).
double loop_loss(const ComponentLaw& law, const Loop& loop);

}  // namespace pliant::test
