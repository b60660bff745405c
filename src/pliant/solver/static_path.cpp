#include "pliant/solver/static_path.h"

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/stopwatch.h"
#include "pliant/solver/outside_work.h"
#include "pliant/solver/within_limits.h"

namespace pliant {
namespace {

std::string at_time(double time) { return " at " + std::to_string(time) + " s"; }

}  // namespace

StaticPath::StaticPath(const System& system, const StaticPathOptions& options)
    : StaticPath(system, options, system.initial_state(options.parameters)) {
  if (options.by.empty()) return;
  // The initial state was brought from the rest shape in one go, by points that no parameter moves.
  State rest = state_;
  rest.history.setZero();
  const Eigen::MatrixXd unmoved =
      Eigen::MatrixXd::Zero(3 * system.points(), std::ssize(options.by));
  system.advance_sensitivity(state_.configuration, {rest, options_.parameters}, options.by, unmoved,
                             history_by_parameter_);
}

StaticPath::StaticPath(const System& system, const StaticPathOptions& options, State start,
                       Eigen::MatrixXd history_by_parameter)
    : system_(system),
      options_(options),
      of_search_(system),
      state_(std::move(start)),
      history_by_parameter_(std::move(history_by_parameter)) {
  PLIANT_ASSERT(options.substeps >= 1, "a step has an equilibrium at its end");
  if (options.by.empty()) return;
  of_derivatives_.emplace(of_search_.another());
  if (history_by_parameter_.size() > 0) return;
  history_by_parameter_ = Eigen::MatrixXd::Zero(state_.history.size(), std::ssize(options.by));
}

void StaticPath::go_on_from(const State& state) {
  state_ = state;
  history_by_parameter_.setZero();
}

PathEquilibrium StaticPath::step(double time, const Configuration& guess) {
  PathEquilibrium point = search(time, guess);
  try {
    differentiate(point);
  } catch (const SolverError&) {
    state_ = std::move(point.ways.front().from);
    throw;
  }
  return point;
}

PathEquilibrium StaticPath::search(double time, const Configuration& guess) {
  PLIANT_ASSERT(time >= state_.time, "a path goes forward in time");
  const Stopwatch watch;
  PathEquilibrium point;
  search(time, guess, point);
  point.search_seconds = watch.seconds();
  return point;
}

void StaticPath::search(double time, const Configuration& guess, PathEquilibrium& point) {
  const double start = state_.time;
  if (guess.positions.size() > 0) {
    PLIANT_ASSERT(options_.substeps == 1, "a guess is of the only equilibrium of a step");
    Controls controls = controls_at(time);
    Configuration at = guess;
    if (find_equilibrium(controls, point, at)) {
      accept(time, std::move(controls), std::move(at), point);
      return;
    }
  }
  for (int i = 1; i <= options_.substeps; ++i) {
    const double part = static_cast<double>(i) / options_.substeps;
    reach(i == options_.substeps ? time : start + part * (time - start), 0, point);
  }
}

void StaticPath::reach(double time, int halvings, PathEquilibrium& point) {
  Controls controls = controls_at(time);
  Configuration at = state_.configuration;
  if (find_equilibrium(controls, point, at)) {
    accept(time, std::move(controls), std::move(at), point);
    return;
  }
  const double middle = (state_.time + time) / 2;
  if (halvings == options_.max_halvings || middle == state_.time) {
    throw SolverError("the equilibrium" + at_time(time), point.newton.iterations,
                      point.newton.residual);
  }
  reach(middle, halvings + 1, point);
  reach(time, halvings + 1, point);
}

bool StaticPath::find_equilibrium(const Controls& controls, PathEquilibrium& point,
                                  Configuration& at) {
  system_.coordinates().apply(controls, at);
  const NewtonSummary found =
      minimize_within_limits(system_, {state_, options_.parameters, controls, {}, &point.costs},
                             options_.newton, of_search_, at);
  const NewtonSummary before = point.newton;
  point.newton = found;
  point.newton.iterations += before.iterations;
  point.newton.factorizations += before.factorizations;
  point.newton.linear_iterations += before.linear_iterations;
  return found.converged;
}

void StaticPath::accept(double time, Controls controls, Configuration at, PathEquilibrium& point) {
  point.time = time;
  ++point.equilibria;
  const Objective objective(system_, {state_, options_.parameters, controls, {}, &point.costs});
  if (options_.by.empty()) {
    point.forces = objective.gradient(at);
    point.outside += outside_work(objective, at, point.forces, controls_at(state_.time));
  }
  State next = state_;
  point.work += objective.advance_history(at, next.history).work;
  next.time = time;
  next.configuration = at;
  std::swap(state_, next);
  if (options_.by.empty()) return;
  point.ways.push_back({std::move(next), std::move(controls), std::move(at)});
}

void StaticPath::differentiate(PathEquilibrium& point) {
  const Stopwatch watch;
  while (!point.ways.empty()) {
    differentiate(point.ways.front(), point);
    point.ways.erase(point.ways.begin());
  }
  point.derivative_seconds += watch.seconds();
}

void StaticPath::differentiate(const PathEquilibrium::Way& way, PathEquilibrium& point) {
  const Conditions under{way.from, options_.parameters, way.controls};
  // Newton's own factor belongs to the iterate before the last, and may be shifted.
  const Objective objective(system_, under);
  const auto factorized = factorize_at(objective, way.to, point.forces, *of_derivatives_);
  const bool usable = factorized == Curvature::exact ||
                      (factorized == Curvature::convex && options_.convex_sensitivities);
  if (!usable) {
    throw SolverError("the sensitivity of the equilibrium" + at_time(point.time) +
                          ", which is not stable (its Hessian is not positive definite)",
                      point.newton.iterations, point.newton.residual);
  }
  point.by_parameter = differentiate_equilibrium(objective, way.to, options_.by,
                                                 history_by_parameter_, *of_derivatives_->solver);
  system_.advance_sensitivity(way.to, under, options_.by, point.by_parameter.positions,
                              history_by_parameter_);
}

}  // namespace pliant
