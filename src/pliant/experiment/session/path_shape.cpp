#include "pliant/experiment/session/path_shape.h"

#include <utility>

namespace pliant {

SheetShape path_shape(const SheetSystem& sheet, Eigen::Matrix3Xd positions,
                      PathEquilibrium& point) {
  SheetShape shape;
  shape.positions = std::move(positions);
  shape.clip_forces = sheet.clip_forces(point.forces);
  shape.clip_moments = sheet.clip_moments(shape.positions, point.forces);
  if (point.by_parameter.positions.size() == 0) return shape;
  shape.clip_forces_by_parameter = sheet.clip_forces_by_parameter(point.by_parameter.forces);
  shape.positions_by_parameter = std::move(point.by_parameter.positions);
  return shape;
}

EquilibriumWork path_work(const PathEquilibrium& point, bool differentiated) {
  const int derivatives = differentiated ? point.equilibria : 0;
  EquilibriumWork work;
  work.counts = {.equilibria = point.equilibria,
                 .iterations = point.newton.iterations,
                 .factors = point.newton.factorizations + derivatives,
                 .differentiated = derivatives};
  work.seconds = {point.search_seconds, point.derivative_seconds};
  return work;
}

}  // namespace pliant
