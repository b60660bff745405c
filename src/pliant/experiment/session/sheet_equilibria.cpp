#include "pliant/experiment/session/sheet_equilibria.h"

#include <cmath>
#include <limits>
#include <mutex>
#include <string>
#include <utility>

#include "pliant/base/parallel.h"
#include "pliant/base/stopwatch.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/solver/equilibrium_derivatives.h"
#include "pliant/solver/within_limits.h"

namespace pliant {
namespace {

constexpr DensityOptions kElastic{.friction = false};
/// Springs softer than this against bending need no softer ones before them (N).
constexpr double kSoftSpring = 1;

}  // namespace

struct SheetEquilibria::Held {
  SheetSystem sheet;
  State rest;  // elasticity remembers nothing
  Workspace workspace;

  Held(const Session& session, const Material& material, std::vector<int> held)
      : sheet(session, material, kElastic, std::move(held)),
        rest(sheet.system().initial_state()),
        workspace(sheet.system()) {}
};

/// Made by the first thread that needs it.
struct SheetEquilibria::Place {
  std::once_flag made;
  std::optional<const Held> held;
};

class SheetEquilibria::Search {
 public:
  Search(const Held& held, const Eigen::VectorXd& parameters, const StopToken& stop)
      : held_(held),
        values_(parameters),
        parameters_(system().with(parameters)),
        workspace_(held.workspace.another()),
        stop_(stop) {}

  const SheetSystem& sheet() const { return held_.sheet; }
  bool is_limited() const { return system().is_limited(); }
  const Eigen::VectorXd& values() const { return values_; }

  NewtonSummary relax(Configuration& at) {
    return minimize_within_limits(
        system(), {held_.rest, parameters_},
        {.tolerance = sheet().tolerance(), .reuse_factor = true, .stop = stop_}, workspace_, at);
  }

  /// Springs that are stiff against bending lead a search along narrow valleys, which take hundreds
  /// of iterations; with soft ones first, and then ever stiffer ones, it is a sixth of that.
  /// @param at  where to begin, then near the equilibrium
  void stiffen_springs(Configuration& at) {
    constexpr double kStiffer = 10, kTolerance = 1e-6;
    const std::vector<std::string>& names = system().parameters().names;
    std::vector<Eigen::Index> bending;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].starts_with("bend.")) bending.push_back(static_cast<Eigen::Index>(i));
    }
    const double stiffest = values_(bending).maxCoeff();
    for (double soft = kSoftSpring; soft < stiffest; soft *= kStiffer) {
      Eigen::VectorXd softer = values_;
      softer(bending) *= soft / stiffest;
      const Parameters soft_springs = system().with(softer);
      minimize(objective(soft_springs),
               {.tolerance = kTolerance, .reuse_factor = true, .stop = stop_}, workspace_, at);
    }
  }

  /// @return which Hessian the derivatives are of; nothing, and no derivatives, where neither can
  ///         be factorised
  std::optional<Curvature> differentiate(const Configuration& at, const std::vector<int>& by,
                                         EquilibriumDerivatives& derivatives) {
    Eigen::Matrix3Xd gradient;
    const auto factorized = factorize_at(objective(parameters_), at, gradient, workspace_);
    if (!factorized) return std::nullopt;
    const Eigen::MatrixXd no_history =
        Eigen::MatrixXd::Zero(held_.rest.history.size(), std::ssize(by));
    derivatives = differentiate_equilibrium(objective(parameters_), at, by, no_history,
                                            *workspace_.solver, sheet().has_clips());
    return factorized;
  }

  SheetShape shape(const Configuration& at) const {
    const Eigen::Matrix3Xd gradient = objective(parameters_).gradient(at);
    return {at.positions,
            sheet().clip_forces(gradient),
            {},
            {},
            sheet().clip_moments(at.positions, gradient)};
  }

 private:
  const System& system() const { return held_.sheet.system(); }
  Objective objective(const Parameters& parameters) const {
    return {system(), {held_.rest, parameters}};
  }

  const Held& held_;
  const Eigen::VectorXd& values_;
  Parameters parameters_;
  Workspace workspace_;
  StopToken stop_;
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

SheetEquilibria::SheetEquilibria(const Session& session, const Material& material)
    : session_(session),
      material_(material),
      states_(sheet_states(session)),
      reached_(states_.states.size()) {
  for (const SheetState& state : states_.states) {
    std::unique_ptr<Place>& place = held_[state.held];
    if (!place) place = std::make_unique<Place>();
  }
  const SheetSystem& first = held(0).sheet;
  parameters_ = first.system().parameters();
  warnings_ = first.warnings();
}

SheetEquilibria::~SheetEquilibria() = default;

const SheetEquilibria::Held& SheetEquilibria::held(int state) {
  const std::vector<int>& nodes = states_.states[static_cast<std::size_t>(state)].held;
  Place& place = *held_.at(nodes);
  std::call_once(place.made, [&] { place.held.emplace(session_, material_, nodes); });
  return *place.held;
}

SheetEquilibria::Search SheetEquilibria::search(int state, const Eigen::VectorXd& parameters) {
  return {held(state), parameters, stop_};
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

bool SheetEquilibria::find(int state, Search& search, Eigen::Matrix3Xd start) {
  const auto s = static_cast<std::size_t>(state);
  Reached& reached = reached_[s];
  Configuration at = search.sheet().configuration(states_.states[s].frame, std::move(start));
  const NewtonSummary newton = search.relax(at);
  reached.work.counts.iterations += newton.iterations;
  reached.work.counts.factors += newton.factorizations;
  reached.found = newton.converged;
  if (!reached.found) return false;
  ++reached.work.counts.equilibria;
  reached.differentiated = false;
  reached.parameters = search.values();
  reached.shape = search.shape(at);
  const auto frame = static_cast<std::size_t>(states_.states[s].frame);
  const Eigen::Matrix3Xd& measured = session_.frames[frame].positions;
  reached.distance = (at.positions - measured).norm() /
                     std::sqrt(static_cast<double>(std::max<Eigen::Index>(measured.cols(), 1)));
  return true;
}

bool SheetEquilibria::differentiate(int state, Search& search, const std::vector<int>& by) {
  const auto s = static_cast<std::size_t>(state);
  Reached& reached = reached_[s];
  const Stopwatch watch;
  if (search.is_limited()) {
    reached.differentiated = take_differences(state, by);
    reached.by = by;
    reached.work.seconds.derivatives += watch.seconds();
    return reached.differentiated;
  }
  const Configuration at =
      search.sheet().configuration(states_.states[s].frame, reached.shape.positions);
  EquilibriumDerivatives derivatives;
  ++reached.work.counts.factors;
  const std::optional<Curvature> curvature = search.differentiate(at, by, derivatives);
  if (!curvature) return false;
  if (curvature == Curvature::convex) ++reached.work.counts.unstable;
  reached.shape.clip_forces_by_parameter =
      search.sheet().clip_forces_by_parameter(derivatives.forces);
  reached.shape.positions_by_parameter = std::move(derivatives.positions);
  reached.differentiated = true;
  reached.by = by;
  ++reached.work.counts.differentiated;
  reached.work.seconds.derivatives += watch.seconds();
  return true;
}

// Where limits of energies hold, multipliers of hundreds stand against shares of 1e-8 that are left
// of them: what the exact derivatives are sums of is 1e9 times what they come to, and rounding eats
// them. Neighbouring equilibria tell them to some parts of a thousand.
bool SheetEquilibria::take_differences(int state, const std::vector<int>& by) {
  constexpr double kStep = 1e-4;
  Reached& reached = reached_[static_cast<std::size_t>(state)];
  const int frame = states_.states[static_cast<std::size_t>(state)].frame;
  SheetShape& shape = reached.shape;
  shape.positions_by_parameter.resize(shape.positions.size(), std::ssize(by));
  shape.clip_forces_by_parameter.resize(shape.clip_forces.size(), std::ssize(by));
  for (std::size_t k = 0; k < by.size(); ++k) {
    const double value = reached.parameters(by[k]);
    const double step = kStep * (value != 0 ? std::abs(value) : reached.parameters.maxCoeff());
    std::vector<SheetShape> beside;
    for (const double side : {step, -step}) {
      Eigen::VectorXd parameters = reached.parameters;
      parameters(by[k]) += side;
      Search search = this->search(state, parameters);
      Configuration at = search.sheet().configuration(frame, shape.positions);
      const NewtonSummary newton = search.relax(at);
      reached.work.counts.iterations += newton.iterations;
      reached.work.counts.factors += newton.factorizations;
      if (!newton.converged) return false;
      beside.push_back(search.shape(at));
    }
    const auto column = static_cast<Eigen::Index>(k);
    shape.positions_by_parameter.col(column) =
        (beside[0].positions - beside[1].positions).reshaped() / (2 * step);
    shape.clip_forces_by_parameter.col(column) =
        (beside[0].clip_forces - beside[1].clip_forces).reshaped() / (2 * step);
  }
  ++reached.work.counts.differentiated;
  return true;
}

bool SheetEquilibria::find_from_measured(int state, Search& search) {
  const int frame = states_.states[static_cast<std::size_t>(state)].frame;
  Configuration at = search.sheet().configuration(
      frame, session_.frames[static_cast<std::size_t>(frame)].positions);
  if (material_.bending == "spring") search.stiffen_springs(at);
  return find(state, search, std::move(at.positions));
}

// A sheet has many equilibria, and a search may fall into one that others then begin at: where it
// has gone far from the measured shape, the search from there counts if it stays nearer.
bool SheetEquilibria::find_near_measured(int state, Search& search) {
  constexpr double kFarther = 1.5, kSmall = 0.01;
  const auto s = static_cast<std::size_t>(state);
  Reached& reached = reached_[s];
  bool found = false;
  for (Eigen::Matrix3Xd& start : starts(state, search.values())) {
    found = find(state, search, std::move(start));
    if (found) break;
  }
  if (!found && !find_from_measured(state, search)) return false;
  const double side = std::max(session_.sample.width, session_.sample.height);
  if (reached.distance > kFarther * reached.nearest + kSmall * side) {
    const Reached farther = reached;
    const bool again = find_from_measured(state, search);
    if (!again || reached.distance > farther.distance) {
      const EquilibriumWork work = reached.work;
      reached = farther;
      reached.work = work;
    }
  }
  reached.nearest = std::min(reached.nearest, reached.distance);
  return true;
}

void SheetEquilibria::reach(int state, const Eigen::VectorXd& parameters,
                            const std::vector<int>& by) {
  Reached& reached = reached_[static_cast<std::size_t>(state)];
  reached.work = {};
  const bool here = reached.found && reached.parameters == parameters;
  if (here && (by.empty() || (reached.differentiated && reached.by == by))) return;

  const Stopwatch watch;
  Search search = this->search(state, parameters);
  const bool found = here || find_near_measured(state, search);
  reached.work.seconds.search += watch.seconds();
  // An equilibrium that nothing can be said of but where it is does not count as found.
  if (found && !by.empty()) reached.found = differentiate(state, search, by);
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
    const Stopwatch watch;
    Search search = this->search(state, parameters);
    const bool found = find(state, search, other.shape.positions);
    reached.work.seconds.search += watch.seconds();
    if (found && !by.empty()) reached.found = differentiate(state, search, by);
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
