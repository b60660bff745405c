#include "pliant/experiment/session/sheet_equilibria.h"

#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

#include "pliant/base/parallel.h"
#include "pliant/base/stopwatch.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/math/sparse_cholesky.h"
#include "pliant/solver/equilibrium_derivatives.h"
#include "pliant/solver/newton.h"

namespace pliant {
namespace {

constexpr DensityOptions kElastic{.friction = false};
/// Springs softer than this against bending need no softer ones before them (N).
constexpr double kSoftSpring = 1;

}  // namespace

class SheetEquilibria::Lane {
 public:
  Lane(const Session& session, const Material& material, std::vector<int> held)
      : sheet_(session, material, kElastic, std::move(held)),
        rest_(sheet_.system().initial_state()),
        hessian_(sheet_.system().make_hessian()),
        solver_(hessian_.matrix) {}

  SheetSystem& sheet() { return sheet_; }
  const SheetSystem& sheet() const { return sheet_; }

  NewtonSummary relax(Configuration& at, const StopToken& stop) {
    return minimize(objective(),
                    {.tolerance = sheet_.tolerance(), .reuse_factor = true, .stop = stop}, solver_,
                    hessian_, at);
  }

  /// Springs that are stiff against bending lead a search along narrow valleys, which take hundreds
  /// of iterations; with soft ones first, and then ever stiffer ones, it is a sixth of that.
  /// @param at  where to begin, then near the equilibrium of `parameters`
  void stiffen_springs(const Eigen::VectorXd& parameters, Configuration& at,
                       const StopToken& stop) {
    constexpr double kStiffer = 10, kTolerance = 1e-6;
    const std::vector<std::string>& names = sheet_.parameters().names;
    std::vector<Eigen::Index> bending;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].starts_with("bend.")) bending.push_back(static_cast<Eigen::Index>(i));
    }
    const double stiffest = parameters(bending).maxCoeff();
    for (double soft = kSoftSpring; soft < stiffest; soft *= kStiffer) {
      Eigen::VectorXd softer = parameters;
      softer(bending) *= soft / stiffest;
      sheet_.system().set_parameters(softer);
      minimize(objective(), {.tolerance = kTolerance, .reuse_factor = true, .stop = stop}, solver_,
               hessian_, at);
    }
    sheet_.system().set_parameters(parameters);
  }

  /// @return which Hessian the derivatives are of; nothing, and no derivatives, where neither can
  /// be
  ///         factorised
  std::optional<Curvature> differentiate(const Configuration& at,
                                         EquilibriumDerivatives& derivatives) {
    Eigen::Matrix3Xd gradient;
    const auto factorized = factorize_at(objective(), at, gradient, hessian_, solver_);
    if (!factorized) return std::nullopt;
    const Eigen::MatrixXd no_history =
        Eigen::MatrixXd::Zero(rest_.history.size(), sheet_.system().derivative_count());
    derivatives =
        differentiate_equilibrium(objective(), at, no_history, solver_, sheet_.has_clips());
    return factorized;
  }

  SheetShape shape(const Configuration& at) const {
    const Eigen::Matrix3Xd gradient = objective().gradient(at);
    return {at.positions,
            sheet_.clip_forces(gradient),
            {},
            {},
            sheet_.clip_moments(at.positions, gradient)};
  }

 private:
  Objective objective() const { return {sheet_.system(), rest_}; }

  SheetSystem sheet_;
  State rest_;  // elasticity remembers nothing
  Hessian hessian_;
  SparseCholesky solver_;
};

struct SheetEquilibria::Reached {
  bool found = false;           // with the last parameters
  bool differentiated = false;  // the shape, which is that of the last parameters that had one
  double distance = 0;          // from the measured shape (m, RMS)
  double nearest = std::numeric_limits<double>::infinity();  // of all that were found
  Eigen::VectorXd parameters;
  std::vector<int> by;
  SheetShape shape;
  EquilibriumWork work;  // of the last time
};

/// Systems that nobody uses now, by the nodes that they hold.
struct SheetEquilibria::Pool {
  std::mutex mutex;
  std::map<std::vector<int>, std::vector<std::unique_ptr<Lane>>> idle;
};

SheetEquilibria::SheetEquilibria(const Session& session, const Material& material)
    : session_(session),
      material_(material),
      states_(sheet_states(session)),
      reached_(states_.states.size()),
      pool_(std::make_unique<Pool>()) {
  std::unique_ptr<Lane> lane = borrow(states_.states.front().held);
  parameters_ = lane->sheet().parameters();
  warnings_ = lane->sheet().warnings();
  give_back(std::move(lane));
}

SheetEquilibria::~SheetEquilibria() = default;

std::unique_ptr<SheetEquilibria::Lane> SheetEquilibria::borrow(const std::vector<int>& held) {
  {
    const std::lock_guard lock(pool_->mutex);
    auto& idle = pool_->idle[held];
    if (!idle.empty()) {
      std::unique_ptr<Lane> lane = std::move(idle.back());
      idle.pop_back();
      return lane;
    }
  }
  return std::make_unique<Lane>(session_, material_, held);
}

void SheetEquilibria::give_back(std::unique_ptr<Lane> lane) {
  const std::lock_guard lock(pool_->mutex);
  pool_->idle[lane->sheet().held()].push_back(std::move(lane));
}

std::vector<Eigen::Matrix3Xd> SheetEquilibria::guesses() const {
  std::vector<Eigen::Matrix3Xd> shapes;
  for (const Reached& reached : reached_) shapes.push_back(reached.shape.positions);
  return shapes;
}

std::vector<Eigen::Matrix3Xd> SheetEquilibria::starts(int state,
                                                      const Eigen::VectorXd& parameters) const {
  const auto s = static_cast<std::size_t>(state);
  const Reached& reached = reached_[s];
  std::vector<Eigen::Matrix3Xd> starts;
  if (reached.shape.positions.size() > 0) {
    starts.push_back(reached.shape.positions);
    if (reached.differentiated) {
      const Eigen::VectorXd change = parameters(reached.by) - reached.parameters(reached.by);
      starts.back() +=
          (reached.shape.positions_by_parameter * change).reshaped(3, starts.back().cols());
    }
  } else if (!guesses_.empty() && guesses_[s].size() > 0) {
    starts.push_back(guesses_[s]);
  }
  return starts;
}

bool SheetEquilibria::find(int state, Lane& lane, const Eigen::VectorXd& parameters,
                           Eigen::Matrix3Xd start) {
  const auto s = static_cast<std::size_t>(state);
  Reached& reached = reached_[s];
  Configuration at = lane.sheet().configuration(states_.states[s].frame, std::move(start));
  const NewtonSummary newton = lane.relax(at, stop_);
  reached.work.counts.iterations += newton.iterations;
  reached.work.counts.factors += newton.factorizations;
  reached.found = newton.converged;
  if (!reached.found) return false;
  ++reached.work.counts.equilibria;
  reached.differentiated = false;
  reached.parameters = parameters;
  reached.shape = lane.shape(at);
  const auto frame = static_cast<std::size_t>(states_.states[s].frame);
  const Eigen::Matrix3Xd& measured = session_.frames[frame].positions;
  reached.distance = (at.positions - measured).norm() /
                     std::sqrt(static_cast<double>(std::max<Eigen::Index>(measured.cols(), 1)));
  return true;
}

bool SheetEquilibria::differentiate(int state, Lane& lane, const std::vector<int>& by) {
  const auto s = static_cast<std::size_t>(state);
  Reached& reached = reached_[s];
  const Stopwatch watch;
  const Configuration at =
      lane.sheet().configuration(states_.states[s].frame, reached.shape.positions);
  EquilibriumDerivatives derivatives;
  ++reached.work.counts.factors;
  const std::optional<Curvature> curvature = lane.differentiate(at, derivatives);
  if (!curvature) return false;
  if (curvature == Curvature::convex) ++reached.work.counts.unstable;
  reached.shape.clip_forces_by_parameter =
      lane.sheet().clip_forces_by_parameter(derivatives.forces);
  reached.shape.positions_by_parameter = std::move(derivatives.positions);
  reached.differentiated = true;
  reached.by = by;
  ++reached.work.counts.differentiated;
  reached.work.seconds.derivatives += watch.seconds();
  return true;
}

bool SheetEquilibria::find_from_measured(int state, Lane& lane, const Eigen::VectorXd& parameters) {
  const int frame = states_.states[static_cast<std::size_t>(state)].frame;
  Configuration at =
      lane.sheet().configuration(frame, session_.frames[static_cast<std::size_t>(frame)].positions);
  if (material_.bending == "spring") lane.stiffen_springs(parameters, at, stop_);
  return find(state, lane, parameters, std::move(at.positions));
}

// A sheet has many equilibria, and a search may fall into one that others then begin at: where it
// has gone far from the measured shape, the search from there counts if it stays nearer.
bool SheetEquilibria::find_near_measured(int state, Lane& lane, const Eigen::VectorXd& parameters) {
  constexpr double kFarther = 1.5, kSmall = 0.01;
  const auto s = static_cast<std::size_t>(state);
  Reached& reached = reached_[s];
  bool found = false;
  for (Eigen::Matrix3Xd& start : starts(state, parameters)) {
    found = find(state, lane, parameters, std::move(start));
    if (found) break;
  }
  if (!found && !find_from_measured(state, lane, parameters)) return false;
  const double side = std::max(session_.sample.width, session_.sample.height);
  if (reached.distance > kFarther * reached.nearest + kSmall * side) {
    const Reached farther = reached;
    const bool again = find_from_measured(state, lane, parameters);
    if (!again || reached.distance > farther.distance) {
      const EquilibriumWork work = reached.work;
      reached = farther;
      reached.work = work;
    }
  }
  reached.nearest = std::min(reached.nearest, reached.distance);
  return true;
}

std::unique_ptr<SheetEquilibria::Lane> SheetEquilibria::prepared(int state,
                                                                 const Eigen::VectorXd& parameters,
                                                                 const std::vector<int>& by) {
  std::unique_ptr<Lane> lane = borrow(states_.states[static_cast<std::size_t>(state)].held);
  lane->sheet().system().set_parameters(parameters);
  lane->sheet().system().differentiate_by(by);
  return lane;
}

void SheetEquilibria::reach(int state, const Eigen::VectorXd& parameters,
                            const std::vector<int>& by) {
  Reached& reached = reached_[static_cast<std::size_t>(state)];
  reached.work = {};
  const bool here = reached.found && reached.parameters == parameters;
  if (here && (by.empty() || (reached.differentiated && reached.by == by))) return;

  std::unique_ptr<Lane> lane = prepared(state, parameters, by);
  const Stopwatch watch;
  const bool found = here || find_near_measured(state, *lane, parameters);
  reached.work.seconds.search += watch.seconds();
  // An equilibrium that nothing can be said of but where it is does not count as found.
  if (found && !by.empty()) reached.found = differentiate(state, *lane, by);
  give_back(std::move(lane));
}

// A shape of another frame is farther away than the measured one, but in balance. One state after
// the other, so that no result depends on the order of threads.
void SheetEquilibria::reach_from_neighbours(const Eigen::VectorXd& parameters,
                                            const std::vector<int>& by) {
  const int count = equilibria_each();
  const auto try_from = [&](int state, int neighbour) {
    if (neighbour < 0 || neighbour >= count) return;
    Reached& reached = reached_[static_cast<std::size_t>(state)];
    const Reached& other = reached_[static_cast<std::size_t>(neighbour)];
    if (reached.found || !other.found) return;
    std::unique_ptr<Lane> lane = prepared(state, parameters, by);
    const Stopwatch watch;
    const bool found = find(state, *lane, parameters, other.shape.positions);
    reached.work.seconds.search += watch.seconds();
    if (found && !by.empty()) reached.found = differentiate(state, *lane, by);
    give_back(std::move(lane));
  };
  for (int state = 0; state < count; ++state) try_from(state, state - 1);
  for (int state = count; state-- > 0;) try_from(state, state + 1);
}

bool SheetEquilibria::found(int frame) const {
  const SheetBlend& blend = states_.frames[static_cast<std::size_t>(frame)];
  return reached_[static_cast<std::size_t>(blend.first)].found &&
         reached_[static_cast<std::size_t>(blend.second)].found;
}

SheetShape SheetEquilibria::blended(int frame, bool derivatives) const {
  const SheetBlend& blend = states_.frames[static_cast<std::size_t>(frame)];
  SheetShape shape = reached_[static_cast<std::size_t>(blend.first)].shape;
  if (!derivatives) {
    shape.positions_by_parameter.resize(0, 0);
    shape.clip_forces_by_parameter.resize(0, 0);
  }
  if (blend.share == 0) return shape;
  return between(std::move(shape), reached_[static_cast<std::size_t>(blend.second)].shape,
                 blend.share);
}

std::vector<std::optional<SheetShape>> SheetEquilibria::predict_each(
    const Eigen::VectorXd& parameters, const std::vector<int>& by, int threads,
    const StopToken& stop) {
  stop_ = stop;
  parallel_for(equilibria_each(), threads, [&](int state) {
    stop.throw_if_requested();
    reach(state, parameters, by);
  });
  reach_from_neighbours(parameters, by);
  for (const Reached& reached : reached_) work_ += reached.work;
  std::vector<std::optional<SheetShape>> shapes(session_.frames.size());
  for (int frame = 0; frame < session_.frame_count(); ++frame) {
    if (found(frame)) shapes[static_cast<std::size_t>(frame)] = blended(frame, !by.empty());
  }
  return shapes;
}

}  // namespace pliant
