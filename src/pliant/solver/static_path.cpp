#include "pliant/solver/static_path.h"

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/stopwatch.h"

namespace pliant {
namespace {

std::string at_time(double time) { return " at " + std::to_string(time) + " s"; }

}  // namespace

StaticPath::StaticPath(const System& system, const StaticPathOptions& options)
    : StaticPath(system, options, system.initial_state()) {
  if (!options.sensitivities) return;
  // The initial state was brought from the rest shape in one go, by points that no parameter moves.
  State rest = state_;
  rest.history.setZero();
  const Eigen::MatrixXd unmoved =
      Eigen::MatrixXd::Zero(3 * system.points(), system.derivative_count());
  system.advance_sensitivity(state_.configuration, rest, unmoved, history_by_parameter_);
}

StaticPath::StaticPath(const System& system, const StaticPathOptions& options, State start,
                       Eigen::MatrixXd history_by_parameter)
    : system_(system),
      options_(options),
      hessian_(system.make_hessian()),
      solver_(hessian_.matrix),
      state_(std::move(start)),
      history_by_parameter_(std::move(history_by_parameter)) {
  PLIANT_ASSERT(options.substeps >= 1, "a step has an equilibrium at its end");
  if (!options.sensitivities || history_by_parameter_.size() > 0) return;
  history_by_parameter_ = Eigen::MatrixXd::Zero(state_.history.size(), system.derivative_count());
}

void StaticPath::go_on_from(const State& state) {
  state_ = state;
  if (options_.sensitivities) history_by_parameter_.setZero();
}

PathEquilibrium StaticPath::step(double time, const Configuration& guess) {
  PLIANT_ASSERT(time >= state_.time, "a path goes forward in time");
  const double start = state_.time;
  PathEquilibrium point;
  if (guess.positions.size() > 0) {
    PLIANT_ASSERT(options_.substeps == 1, "a guess is of the only equilibrium of a step");
    Configuration at = guess;
    if (find_equilibrium(time, point, at)) {
      accept(time, std::move(at), point);
      return point;
    }
  }
  for (int i = 1; i <= options_.substeps; ++i) {
    const double part = static_cast<double>(i) / options_.substeps;
    reach(i == options_.substeps ? time : start + part * (time - start), 0, point);
  }
  return point;
}

void StaticPath::reach(double time, int halvings, PathEquilibrium& point) {
  Configuration at = state_.configuration;
  if (find_equilibrium(time, point, at)) {
    accept(time, std::move(at), point);
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

bool StaticPath::find_equilibrium(double time, PathEquilibrium& point, Configuration& at) {
  system_.drive(time, at);
  const NewtonSummary found =
      minimize(Objective(system_, state_), options_.newton, solver_, hessian_, at);
  const NewtonSummary before = point.newton;
  point.newton = found;
  point.newton.iterations += before.iterations;
  point.newton.factorizations += before.factorizations;
  point.newton.linear_iterations += before.linear_iterations;
  return found.converged;
}

void StaticPath::accept(double time, Configuration at, PathEquilibrium& point) {
  point.time = time;
  ++point.equilibria;
  if (options_.sensitivities) {
    const Stopwatch watch;
    // Newton's own factor belongs to the iterate before the last, and may be shifted.
    const Objective objective(system_, state_);
    const auto factorized = factorize_at(objective, at, point.forces, hessian_, solver_);
    const bool usable = factorized == Curvature::exact ||
                        (factorized == Curvature::convex && options_.convex_sensitivities);
    if (!usable) {
      throw SolverError("the sensitivity of the equilibrium" + at_time(time) +
                            ", which is not stable (its Hessian is not positive definite)",
                        point.newton.iterations, point.newton.residual);
    }
    point.by_parameter = differentiate_equilibrium(objective, at, history_by_parameter_, solver_);
    system_.advance_sensitivity(at, state_, point.by_parameter.positions, history_by_parameter_);
    point.derivative_seconds += watch.seconds();
  } else {
    point.forces = Objective(system_, state_).gradient(at);
  }
  Eigen::VectorXd history;
  point.work += system_.advance_history(at, state_, {}, history);
  state_.time = time;
  state_.configuration = std::move(at);
  state_.history = std::move(history);
}

}  // namespace pliant
