#include "pliant/solver/time_stepper.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/math/ssor_cg.h"
#include "pliant/mechanics/point_targets.h"
#include "pliant/solver/descent.h"

namespace pliant {

namespace {

// Newton's method gains nothing from exact steps: it corrects them in the next.
Workspace iterative(const System& system, const TimeStepOptions& options) {
  constexpr double kOfNewtonStep = 1e-2;
  const bool linearized = options.solve == StepSolve::linearized;
  const SsorCg::Options how{.tolerance = linearized ? options.linear_tolerance : kOfNewtonStep};
  Hessian hessian = system.make_hessian();
  auto solver = std::make_unique<SsorCg>(hessian.matrix, how);
  return {std::move(hessian), std::move(solver)};
}

// The change of the unknowns if everything kept its velocity: where the search for the step begins.
// Clips move on without turning; axes that are prescribed stay.
Eigen::VectorXd coasting(const Coordinates& coordinates, const Configuration& at,
                         const Eigen::Matrix3Xd& velocities, double step) {
  Eigen::Matrix3Xd way = step * velocities;
  for (int i = 0; i < coordinates.points(); ++i) {
    if (!coordinates.is_free(i)) way.col(i).setZero();
  }
  Eigen::VectorXd change = coordinates.reduce(at, way);
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (coordinates.clip_is_prescribed(k)) continue;
    change.segment<3>(3 * coordinates.clip_row(k)) =
        step * velocities(Eigen::all, coordinates.clip_points(k)).rowwise().mean();
  }
  return change;
}

StepSummary summary_of(const DescentSummary& descent) {
  return {descent.converged, descent.iterations, descent.linear_iterations, descent.residual};
}

}  // namespace

// new velocity = (x - now) / time: backward Euler has now = x_n, time = h; BDF2 has
// now = (4 x_n - x_n-1) / 3, time = 2 h / 3, and the same weights for velocities and strains.
struct TimeStepper::Scheme {
  double time = 0;
  double now = 1, earlier = 0;

  Scheme(Integrator integrator, double step, const State& state) : time(step) {
    const bool two_steps = integrator == Integrator::bdf2 && state.last_step == step;
    if (!two_steps) return;
    time = 2 * step / 3;
    now = 4.0 / 3;
    earlier = -1.0 / 3;
  }

  Eigen::Matrix3Xd mix(const Eigen::Matrix3Xd& last, const Eigen::Matrix3Xd& before) const {
    if (earlier == 0) return last;
    return now * last + earlier * before;
  }
};

TimeStepper::TimeStepper(const System& system, const TimeStepOptions& options,
                         Eigen::Matrix3Xi faces)
    : system_(system),
      options_(options),
      faces_(std::move(faces)),
      workspace_(iterative(system, options)) {
  PLIANT_ASSERT(options.step > 0, "a time step takes time");
  for (int i = 0; i < system.points(); ++i) {
    PLIANT_ASSERT(system.masses()(i) > 0 || !system.coordinates().is_free(i),
                  "what moves freely has mass");
  }
}

TimeStepper::~TimeStepper() = default;

// What a step minimises, and where the search for it begins.
struct TimeStepper::Trial {
  const State& from;
  const Objective& objective;
  const PointTargets& inertia;
  const Eigen::Matrix3Xd& start;  // where there is no velocity
  double time = 0;                // new velocity = (x - start) / time
  Eigen::VectorXd guess;          // the change of the unknowns

  Eigen::Matrix3Xd velocities(const Configuration& at) const {
    return (at.positions - start) / time;
  }

  // Kinetic energy and potentials, given what the objective has of potentials and inertia.
  double total(const Energy& energy, const Configuration& at,
               const Eigen::Matrix3Xd& velocities) const {
    const double kinetic = velocities.colwise().squaredNorm().dot(objective.system().masses()) / 2;
    return energy.total() - inertia.energy(at.positions) + kinetic;
  }
};

StepSummary TimeStepper::linearized(const Trial& trial, Configuration& at) {
  const Objective& objective = trial.objective;
  const Configuration before = at;
  const DescentSummary once =
      descend(objective, {.iterations = 1, .line_search = false}, trial.guess, workspace_, at);
  StepSummary summary = summary_of(once);
  if (!options_.mend_growth || !once.converged) return summary;
  const double first = trial.total(once.start, before, trial.from.velocities);
  const double now = trial.total(objective.energy(at), at, trial.velocities(at));
  if (now <= first) return summary;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(trial.guess.size());
  const DescentSummary again = descend(objective, {.iterations = 1}, none, workspace_, at);
  summary.newton_iterations += again.iterations;
  summary.linear_iterations += again.linear_iterations;
  return summary;
}

StepSummary TimeStepper::solve(const Trial& trial, Configuration& at) {
  if (options_.solve == StepSolve::linearized) return linearized(trial, at);
  // Where inertia alone leads into an obstacle the search begins where the step does.
  Configuration coasted = system_.coordinates().moved(at, trial.guess);
  if (trial.objective.admits(coasted)) at = std::move(coasted);
  if (options_.solve == StepSolve::iterated) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(trial.guess.size());
    return summary_of(
        descend(trial.objective, {.motion = options_.motion_tolerance}, none, workspace_, at));
  }
  NewtonOptions newton;
  newton.tolerance = options_.tolerance;
  const NewtonSummary solved = minimize(trial.objective, newton, workspace_, at);
  return {solved.converged, solved.iterations, solved.linear_iterations, solved.residual};
}

StepSummary TimeStepper::advance(State& state, double step) {
  const Scheme scheme(options_.integrator, step, state);
  const double time = state.time + step;
  Configuration at = state.configuration;
  const Controls controls = options_.schedule ? options_.schedule(time) : kNoControls;
  system_.coordinates().apply(controls, at);

  const Eigen::Matrix3Xd start = scheme.mix(state.configuration.positions, state.last_positions);
  const Eigen::Matrix3Xd velocities = scheme.mix(state.velocities, state.last_velocities);
  const PointTargets inertia(system_.masses() / (scheme.time * scheme.time),
                             start + scheme.time * velocities);
  const Conditions under{
      .from = state, .controls = controls, .time = {1 / scheme.time, scheme.now, scheme.earlier}};
  Objective objective(system_, under);
  objective.add(inertia);
  std::optional<AirDrag> drag;
  if (options_.air) {
    drag.emplace(*options_.air, faces_, start, state.velocities, scheme.time);
    objective.add(*drag);
  }

  const Trial trial{state,       objective,
                    inertia,     start,
                    scheme.time, coasting(system_.coordinates(), at, state.velocities, step)};
  StepSummary summary = solve(trial, at);
  if (!at.positions.allFinite() || !std::isfinite(summary.residual)) {
    throw SolverError("the time step that ends at " + std::to_string(time) + " s",
                      summary.newton_iterations, summary.residual);
  }

  State next;
  next.time = time;
  next.velocities = trial.velocities(at);
  summary.work = system_.advance_history(at, under, next.history);
  if (drag) summary.drag = drag->work(state.configuration, at);
  next.last_step = step;
  next.last_positions = std::move(state.configuration.positions);
  next.last_velocities = std::move(state.velocities);
  next.configuration = std::move(at);
  state = std::move(next);
  return summary;
}

}  // namespace pliant
