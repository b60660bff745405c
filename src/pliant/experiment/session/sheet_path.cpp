#include "pliant/experiment/session/sheet_path.h"

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/experiment/session/path_shape.h"

namespace pliant {

SheetPath::SheetPath(const Session& session, const Material& material)
    : session_(session), sheet_(session, material, {}, held_nodes(session, std::nullopt)) {
  PLIANT_ASSERT(!session.table, "the table of a path would let go of nodes that it holds");
  parameters_ = sheet_.system().parameters();
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

// The search of a frame needs no derivatives: it goes ahead while those of frames before are taken.
std::vector<std::optional<SheetShape>> SheetPath::predict_each(const Eigen::VectorXd& parameters,
                                                               const std::vector<int>& by,
                                                               int threads, const StopToken& stop) {
  StaticPath path(sheet_.system(),
                  {.newton = {.tolerance = sheet_.tolerance(), .reuse_factor = true, .stop = stop},
                   .schedule = sheet_.schedule(),
                   .parameters = sheet_.system().with(parameters),
                   .by = by,
                   .convex_sensitivities = true});
  const auto count = session_.frames.size();
  std::vector<PathEquilibrium> points(count);
  std::vector<SheetShape> shapes(count);
  std::vector<std::optional<SheetShape>> found(count);
  const auto search = [&](int frame) {
    const auto f = static_cast<std::size_t>(frame);
    points[f] = path.search(frame + 1, {guess(frame, parameters), {}});
    shapes[f].positions = path.state().configuration.positions;
  };
  const auto finish = [&](int frame) {
    const auto f = static_cast<std::size_t>(frame);
    PathEquilibrium point = std::move(points[f]);
    path.differentiate(point);
    work_ += path_work(point, !by.empty());
    shapes[f] = path_shape(sheet_, std::move(shapes[f].positions), point);
    found[f] = shapes[f];
  };
  try {
    with_threads(threads, [&] { pipeline(session_.frame_count(), search, finish); });
  } catch (const SolverError&) {
    return found;  // friction carries on from each frame to the next
  }
  last_ = {parameters, by, std::move(shapes)};
  return found;
}

}  // namespace pliant
