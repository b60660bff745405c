#include "pliant/experiment/session/pushed_sheet.h"

#include <algorithm>
#include <utility>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/experiment/session/path_shape.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/solver/static_path.h"

namespace pliant {
namespace {

/// Of a row: there is no smaller step to take instead.
constexpr int kMostIterations = 2000;

}  // namespace

/// The sheet on its way. The states of a table hold different nodes, but the same elements: what
/// friction remembers goes from the system of one to that of the next.
class PushedSheet::Path {
 public:
  Path(PushedSheet& sheet, const Eigen::VectorXd& parameters, const std::vector<int>& by,
       const StopToken& stop)
      : sheet_(sheet),
        parameters_(parameters),
        by_(by),
        stop_(stop),
        shapes_(sheet.states_.states.size()),
        row_(static_cast<int>(shapes_.size())),
        before_(row_) {}

  /// Goes on to a frame.
  /// @throws SolverError
  SheetShape frame(int frame) {
    const SheetBlend& blend = sheet_.states_.frames[static_cast<std::size_t>(frame)];
    const int outer = blend.share < 1 ? blend.first : blend.second;
    const int inner = blend.share > 0 ? blend.second : blend.first;
    go_to(outer, inner, frame);
    const SheetShape& shape = shapes_[static_cast<std::size_t>(outer)];
    if (outer == inner) return shape;
    return between(shape, shapes_[static_cast<std::size_t>(inner)], blend.share);
  }

  const EquilibriumWork& work() const { return work_; }

 private:
  // Between two neighbouring rows of which the first is further out, or to one row.
  void go_to(int outer, int inner, int frame) {
    const bool there =
        outer == inner ? row_ == outer : std::minmax({before_, row_}) == std::pair(outer, inner);
    if (there) return;
    if (row_ > outer) {
      while (row_ > outer) step_to(row_ - 1, frame);
    } else {
      while (row_ < inner) step_to(row_ + 1, frame);
    }
  }

  // A row further out or back.
  void step_to(int row, int frame) {
    const SheetSystem& sheet = sheet_.held_at(row);
    const System& system = sheet.system();
    const Parameters parameters = system.with(parameters_);
    if (state_.history.size() == 0) state_ = system.initial_state(parameters);
    StaticPath path(system,
                    {.newton = {.tolerance = sheet.tolerance(),
                                .max_iterations = kMostIterations,
                                .reuse_factor = true,
                                .stop = stop_},
                     .max_halvings = 0,
                     .schedule = [&](double) { return sheet.controls(frame); },
                     .parameters = parameters,
                     .by = by_,
                     .convex_sensitivities = true},
                    std::move(state_), std::move(history_by_parameter_));
    PathEquilibrium point = path.step(path.state().time + 1);
    work_ += path_work(point, !by_.empty());
    state_ = path.state();
    history_by_parameter_ = path.history_by_parameter();
    shapes_[static_cast<std::size_t>(row)] =
        path_shape(sheet, state_.configuration.positions, point);
    before_ = std::exchange(row_, row);
  }

  PushedSheet& sheet_;
  const Eigen::VectorXd& parameters_;
  const std::vector<int>& by_;
  StopToken stop_;

  State state_;
  Eigen::MatrixXd history_by_parameter_;
  std::vector<SheetShape> shapes_;  // that each state had last
  int row_;                         // the state that the path stands at; first beyond the last one
  int before_;                      // where it came from
  EquilibriumWork work_;
};

PushedSheet::PushedSheet(const Session& session, const Material& material)
    : session_(session), material_(material), states_(states_on_table(session)) {
  sheets_.resize(states_.states.size());
  const SheetSystem& sheet = held_at(static_cast<int>(sheets_.size()) - 1);
  parameters_ = sheet.system().parameters();
  warnings_ = sheet.warnings();
}

const SheetSystem& PushedSheet::held_at(int row) {
  const auto r = static_cast<std::size_t>(row);
  if (!sheets_[r]) {
    sheets_[r] = std::make_unique<const SheetSystem>(session_, material_, DensityOptions{},
                                                     states_.states[r].held);
  }
  return *sheets_[r];
}

std::vector<std::optional<SheetShape>> PushedSheet::predict_each(const Eigen::VectorXd& parameters,
                                                                 const std::vector<int>& by,
                                                                 int threads,
                                                                 const StopToken& stop) {
  Path path(*this, parameters, by, stop);
  std::vector<std::optional<SheetShape>> found(session_.frames.size());
  try {
    with_threads(threads, [&] {
      for (int frame = 0; frame < session_.frame_count(); ++frame) {
        found[static_cast<std::size_t>(frame)] = path.frame(frame);
      }
    });
  } catch (const SolverError&) {
    // Friction carries on from each frame to the next: none of the later ones is found.
  }
  work_ += path.work();
  return found;
}

}  // namespace pliant
