#include "pliant/experiment/session/sheet_path.h"

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/stopwatch.h"
#include "pliant/experiment/session/path_shape.h"

namespace pliant {

SheetPath::SheetPath(const Session& session, const Material& material)
    : session_(session), sheet_(session, material, {}, held_nodes(session, std::nullopt)) {
  PLIANT_ASSERT(!session.table, "the table of a path would let go of nodes that it holds");
  sheet_.system().add_drive(held_drive(session_, sheet_.held()));
  parameters_ = sheet_.parameters();
  warnings_ = sheet_.warnings();
}

std::vector<Eigen::Matrix3Xd> SheetPath::guesses() const {
  std::vector<Eigen::Matrix3Xd> shapes;
  for (const SheetShape& shape : last_.shapes) shapes.push_back(shape.positions);
  return shapes;
}

Eigen::Matrix3Xd SheetPath::guess(int frame, const Eigen::VectorXd& parameters) const {
  const auto f = static_cast<std::size_t>(frame);
  if (last_.shapes.empty()) return f < guesses_.size() ? guesses_[f] : Eigen::Matrix3Xd();
  const SheetShape& before = last_.shapes[f];
  if (last_.by.empty()) return before.positions;
  const Eigen::VectorXd change = parameters(last_.by) - last_.parameters(last_.by);
  return before.positions +
         (before.positions_by_parameter * change).reshaped(3, before.positions.cols());
}

std::vector<std::optional<SheetShape>> SheetPath::predict_each(const Eigen::VectorXd& parameters,
                                                               const std::vector<int>& by,
                                                               int threads, const StopToken& stop) {
  sheet_.system().set_threads(threads);
  sheet_.system().set_parameters(parameters);
  sheet_.system().differentiate_by(by);
  StaticPath path(sheet_.system(),
                  {.newton = {.tolerance = sheet_.tolerance(), .reuse_factor = true, .stop = stop},
                   .sensitivities = !by.empty(),
                   .convex_sensitivities = true});
  std::vector<SheetShape> shapes;
  std::vector<std::optional<SheetShape>> found(session_.frames.size());
  try {
    for (int frame = 0; frame < session_.frame_count(); ++frame) {
      const Stopwatch watch;
      PathEquilibrium point = path.step(frame + 1, {guess(frame, parameters), {}});
      work_ += path_work(point, watch.seconds(), !by.empty());
      shapes.push_back(path_shape(sheet_, path.state(), point));
      found[static_cast<std::size_t>(frame)] = shapes.back();
    }
  } catch (const SolverError&) {
    return found;  // friction carries on from each frame to the next
  }
  last_ = {parameters, by, std::move(shapes)};
  return found;
}

}  // namespace pliant
