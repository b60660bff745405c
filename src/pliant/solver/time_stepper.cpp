#include "pliant/solver/time_stepper.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/math/ssor_cg.h"
#include "pliant/mechanics/point_targets.h"

namespace pliant {

namespace {

// Newton's method gains nothing from exact steps: it corrects them in the next.
double linear_tolerance(const TimeStepOptions& options) {
  constexpr double kOfNewtonStep = 1e-2;
  return options.solve == StepSolve::linearized ? options.linear_tolerance : kOfNewtonStep;
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
      hessian_(system.make_hessian()),
      solver_(std::make_unique<SsorCg>(hessian_.matrix,
                                       SsorCg::Options{.tolerance = linear_tolerance(options)})) {
  PLIANT_ASSERT(options.step > 0, "a time step takes time");
  for (int i = 0; i < system.points(); ++i) {
    PLIANT_ASSERT(system.masses()(i) > 0 || !system.coordinates().is_free(i),
                  "what moves freely has mass");
  }
}

TimeStepper::~TimeStepper() = default;

StepSummary TimeStepper::linear_step(const Objective& objective, const State& state, double step,
                                     Configuration& at) {
  const Coordinates& coordinates = system_.coordinates();
  Eigen::Matrix3Xd gradient;
  objective.linearize(at, Curvature::convex, gradient, hessian_);
  StepSummary summary;
  if (!solver_->factorize(hessian_.matrix)) {
    summary.converged = false;
    return summary;
  }
  Eigen::VectorXd change = Eigen::VectorXd::Zero(coordinates.unknowns());
  for (int i = 0; i < system_.points(); ++i) {
    if (coordinates.is_free(i)) {
      change.segment<3>(3 * coordinates.row(i)) = step * state.velocities.col(i);
    }
  }
  const LinearSummary linear = solver_->solve(-coordinates.reduce(at, gradient), change);
  summary.linear_iterations = linear.iterations;
  summary.converged = linear.converged;
  summary.residual = linear.residual;
  at = coordinates.moved(at, change);
  return summary;
}

// Newton's method begins where free points would be without forces.
void TimeStepper::predict(double step, const State& state, Configuration& at) const {
  for (int i = 0; i < system_.points(); ++i) {
    if (!system_.coordinates().is_free(i)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (system_.coordinates().is_axis_prescribed(i, axis)) continue;
      at.positions(axis, i) += step * state.velocities(axis, i);
    }
  }
}

StepSummary TimeStepper::advance(State& state, double step) {
  const Scheme scheme(options_.integrator, step, state);
  const double time = state.time + step;
  Configuration at = state.configuration;
  system_.drive(time, at);

  const Eigen::Matrix3Xd start = scheme.mix(state.configuration.positions, state.last_positions);
  const Eigen::Matrix3Xd velocities = scheme.mix(state.velocities, state.last_velocities);
  const PointTargets inertia(system_.masses() / (scheme.time * scheme.time),
                             start + scheme.time * velocities, PointTargets::Kind::stored);
  Objective objective(system_, state, {1 / scheme.time, scheme.now, scheme.earlier});
  objective.add(inertia);
  std::optional<AirDrag> drag;
  if (options_.air) {
    drag.emplace(*options_.air, faces_, start, state.velocities, scheme.time);
    objective.add(*drag);
  }

  StepSummary summary;
  if (options_.solve == StepSolve::linearized) {
    summary = linear_step(objective, state, step, at);
  } else {
    NewtonOptions newton;
    newton.tolerance = options_.tolerance;
    predict(step, state, at);
    const NewtonSummary solved = minimize(objective, newton, *solver_, hessian_, at);
    summary = {solved.converged, solved.iterations, solved.linear_iterations, solved.residual, 0};
  }
  if (!at.positions.allFinite()) {
    throw SolverError("the time step that ends at " + std::to_string(time) + " s",
                      summary.newton_iterations, summary.residual);
  }

  State next;
  next.time = time;
  next.velocities = (at.positions - start) / scheme.time;
  summary.work = system_.advance_history(at, state, objective.time(), next.history);
  if (drag) summary.work += drag->work(state.configuration, at);
  next.last_step = step;
  next.last_positions = std::move(state.configuration.positions);
  next.last_velocities = std::move(state.velocities);
  next.configuration = std::move(at);
  state = std::move(next);
  return summary;
}

}  // namespace pliant
