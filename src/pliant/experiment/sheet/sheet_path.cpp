#include "pliant/experiment/sheet/sheet_path.h"

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/solver/static_path.h"

namespace pliant {

SheetPath::SheetPath(const Session& session, const Material& material)
    : session_(session), sheet_(session, material, {}, held_nodes(session, std::nullopt)) {
  PLIANT_ASSERT(!session.table, "the table of a path would let go of nodes that it holds");
  sheet_.system().add_drive(held_drive(session_, sheet_.held()));
  parameters_ = sheet_.parameters();
  warnings_ = sheet_.warnings();
}

std::optional<std::vector<SheetShape>> SheetPath::predict(const Eigen::VectorXd& parameters,
                                                          const std::vector<int>& by, int threads,
                                                          const StopToken& stop) {
  sheet_.system().set_threads(threads);
  sheet_.system().set_parameters(parameters);
  sheet_.system().differentiate_by(by);
  StaticPath path(sheet_.system(),
                  {.newton = {.tolerance = sheet_.tolerance(), .reuse_factor = true, .stop = stop},
                   .sensitivities = !by.empty(),
                   .convex_sensitivities = true});
  std::vector<SheetShape> shapes;
  try {
    for (int frame = 0; frame < session_.frame_count(); ++frame) {
      PathEquilibrium point = path.step(frame + 1);
      counts_.equilibria += point.equilibria;
      counts_.iterations += point.newton.iterations;
      counts_.factors += point.newton.factorizations + (by.empty() ? 0 : point.equilibria);
      SheetShape& shape = shapes.emplace_back();
      shape.positions = path.state().configuration.positions;
      shape.clip_forces = sheet_.clip_forces(point.forces);
      shape.clip_moments = sheet_.clip_moments(shape.positions, point.forces);
      if (by.empty()) continue;
      shape.clip_forces_by_parameter = sheet_.clip_forces_by_parameter(point.by_parameter.forces);
      shape.positions_by_parameter = std::move(point.by_parameter.positions);
    }
  } catch (const SolverError&) {
    failed_frame_ = static_cast<int>(shapes.size());
    return std::nullopt;
  }
  return shapes;
}

}  // namespace pliant
