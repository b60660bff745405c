#include "pliant/solver/time_stepper.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/math/ssor_cg.h"
#include "pliant/mechanics/point_targets.h"
#include "pliant/solver/descent.h"
#include "pliant/solver/free_change.h"
#include "pliant/solver/outside_work.h"

namespace pliant {

namespace {

// Of limits of energy: a lower one costs iterations, and the error of a step is larger.
constexpr double kLimitBarrier = 1e-3;

// Newton's method gains nothing from exact steps: it corrects them in the next. What limits hold is
// some 10^5 times as stiff as all else, which single precision does not carry.
Workspace workspace_of(const System& system, const TimeStepOptions& options) {
  if (system.is_limited()) return Workspace(system);
  constexpr double kOfNewtonStep = 1e-2;
  const bool linearized = options.solve == StepSolve::linearized;
  const SsorCg::Options how{.tolerance = linearized ? options.linear_tolerance : kOfNewtonStep};
  Hessian hessian = system.make_hessian(Precision::single);
  auto solver = std::make_unique<SsorCg>(hessian.matrix, how);
  return {std::move(hessian), std::move(solver)};
}

// The change of the unknowns to where everything would be that kept its velocity: where the search
// for the step begins. Clips move on without turning; axes that are prescribed stay.
// @param gone  what they have changed by already
Eigen::VectorXd coasting(const Coordinates& coordinates, const Configuration& at,
                         const Eigen::Matrix3Xd& velocities, double step,
                         const Eigen::VectorXd& gone) {
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
  return change - gone;
}

double kinetic_energy(const System& system, const Eigen::Matrix3Xd& velocities) {
  return velocities.colwise().squaredNorm().dot(system.masses()) / 2;
}

Eigen::VectorXd no_change(const System& system) {
  return Eigen::VectorXd::Zero(system.coordinates().unknowns());
}

StepSummary summary_of(const DescentSummary& descent) {
  return {.converged = descent.converged,
          .newton_iterations = descent.iterations,
          .linear_iterations = descent.linear_iterations,
          .residual = descent.residual};
}

// Beyond what rounding and tolerances leave.
bool has_gained(double total, double before, double kinetic) {
  constexpr double kShare = 1e-4;  // of the energy of motion
  return total > before + kShare * kinetic;
}

// What a search took that goes on from another.
void add_iterations(const StepSummary& on, StepSummary& summary) {
  summary.newton_iterations += on.newton_iterations;
  summary.linear_iterations += on.linear_iterations;
}

// The same where the other ends it.
void go_on(const StepSummary& on, StepSummary& summary) {
  summary.converged = on.converged;
  summary.residual = on.residual;
  add_iterations(on, summary);
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
      workspace_(workspace_of(system, options)) {
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
  const Conditions& under;
  const Objective& objective;
  const PointTargets& inertia;
  const std::optional<AirDrag>& drag;
  const Eigen::Matrix3Xd start;  // where there is no velocity
  double time = 0;               // new velocity = (x - start) / time
  bool gains_nothing = false;    // nothing is led, and one step is all that the scheme looks at
  Eigen::VectorXd guess;         // the change of the unknowns
};

// Accepts what was found, with the memory that it leaves.
// @return kinetic energy, what is stored and what was lost on the way (J)
double TimeStepper::settle(const Trial& trial, Configuration at, State& to,
                           StepSummary& summary) const {
  const Energy energy = trial.objective.advance_history(at, to.history);
  summary.work = energy.work;
  summary.rubbing = energy.rubbing;
  if (trial.drag) summary.drag = trial.drag->work(trial.from.configuration, at);
  to.velocities = (at.positions - trial.start) / trial.time;
  to.configuration = std::move(at);
  return energy.total() + summary.drag + kinetic_energy(system_, to.velocities);
}

StepSummary TimeStepper::linearized(const Trial& trial, Configuration at, State& to) {
  const Configuration before = at;
  const DescentSummary once = descend(trial.objective, {.iterations = 1, .line_search = false},
                                      trial.guess, workspace_, at);
  StepSummary summary = summary_of(once);
  const double stored = once.start.stored - trial.inertia.energy(before.positions);
  const double total = stored + kinetic_energy(system_, trial.from.velocities);
  const bool gained = settle(trial, std::move(at), to, summary) > total;
  if (!once.converged || !options_.mend_growth || !gained) return summary;
  at = to.configuration;
  const DescentSummary again =
      descend(trial.objective, {.iterations = 1}, no_change(system_), workspace_, at);
  add_iterations(summary_of(again), summary);
  settle(trial, std::move(at), to, summary);
  return summary;
}

// Goes down from a guess, which may hold more energy than there was; where too much of it is left,
// from where the step begins.
StepSummary TimeStepper::searched_from(const Trial& trial, const Eigen::VectorXd& guess,
                                       double most_energy, Configuration& at) {
  const Configuration begin = at;
  at = system_.coordinates().moved(begin, guess);
  if (options_.solve != StepSolve::iterated) return searched_at(trial, at);
  const DescentOptions few{.most_energy = most_energy, .motion = options_.motion_tolerance};
  const DescentSummary found = descend(trial.objective, few, no_change(system_), workspace_, at);
  StepSummary summary = summary_of(found);
  if (found.end.total() <= most_energy) return summary;
  at = begin;
  go_on(searched_at(trial, at), summary);
  return summary;
}

StepSummary TimeStepper::searched_at(const Trial& trial, Configuration& at) {
  if (options_.solve == StepSolve::iterated) {
    const DescentOptions few{.motion = options_.motion_tolerance};
    return summary_of(descend(trial.objective, few, no_change(system_), workspace_, at));
  }
  NewtonOptions newton;
  newton.tolerance = options_.tolerance;
  const NewtonSummary solved = minimize(trial.objective, newton, workspace_, at);
  return {.converged = solved.converged,
          .newton_iterations = solved.iterations,
          .linear_iterations = solved.linear_iterations,
          .residual = solved.residual};
}

// What is led goes on as far as it may, and the rest after it, until it has arrived.
StepSummary TimeStepper::searched(const Trial& trial, LedMotion led, Configuration at, State& to) {
  constexpr int kMostTimes = 30;
  constexpr int kMostMore = 20;  // iterations while the total of all energies has grown
  // Where something is in the way, the guess may hold more energy than there was.
  const bool may_gain = system_.obstructs() && led.has_arrived();
  const double most_energy = may_gain ? trial.objective.energy(at).total() : INFINITY;
  const FreeChange guess = free_change(trial.objective, at, trial.guess, led.way_left());
  led.go(guess.led, at);
  const double total = trial.gains_nothing ? most_energy - trial.inertia.energy(at.positions) +
                                                 kinetic_energy(system_, trial.from.velocities)
                                           : INFINITY;
  StepSummary summary = searched_from(trial, guess.each, most_energy, at);
  for (int times = 1; !led.has_arrived(); ++times) {
    if (times == kMostTimes) {
      to.configuration = std::move(at);
      return {.converged = false, .has_room = false, .residual = INFINITY};
    }
    led.go(free_change(trial.objective, at, no_change(system_), led.way_left()).led, at);
    go_on(searched_at(trial, at), summary);
  }
  double reached = settle(trial, at, to, summary);
  for (int more = 0; reached > total && more < kMostMore; ++more) {
    const DescentOptions once{.iterations = 1, .motion = options_.motion_tolerance};
    add_iterations(summary_of(descend(trial.objective, once, no_change(system_), workspace_, at)),
                   summary);
    reached = settle(trial, at, to, summary);
  }
  summary.gained = has_gained(reached, total, kinetic_energy(system_, trial.from.velocities));
  return summary;
}

// What meets what is led goes with it, as far as there is room.
// @param led  where the last step ended, but for what is led: that may be where it goes
std::optional<TimeStepper::Begin> TimeStepper::beginning(const Objective& objective,
                                                         const Configuration& led) const {
  constexpr double kKept = 0.01;  // of the distances to what is passed
  const Configuration& before = objective.conditions().from.configuration;
  const auto way = made_way(objective, led);
  if (!way) return std::nullopt;
  const Configuration at = way->isZero(0) ? led : system_.coordinates().moved(led, *way);
  if (!system_.obstructs() || at.positions == before.positions) return Begin{at, *way};
  const WayLimits limits = objective.way_limits(before, at, kKept);
  const bool is_free = !limits.obstructed && std::isfinite(objective.energy(at).total());
  return is_free ? std::optional(Begin{at, *way}) : std::nullopt;
}

StepSummary TimeStepper::advance(const State& from, double step, State& to) {
  const Scheme scheme(options_.integrator, step, from);
  const double time = from.time + step;
  const Controls controls = options_.schedule ? options_.schedule(time) : kNoControls;
  Configuration end = from.configuration;  // of what is led
  system_.coordinates().apply(controls, end);
  const Eigen::Matrix3Xd start = scheme.mix(from.configuration.positions, from.last_positions);
  const Eigen::Matrix3Xd velocities = scheme.mix(from.velocities, from.last_velocities);
  const PointTargets inertia(system_.masses() / (scheme.time * scheme.time),
                             start + scheme.time * velocities);
  SearchCosts costs;
  const Conditions under{
      .from = from,
      .controls = controls,
      .time = {1 / scheme.time, scheme.now, scheme.earlier, {.share = kLimitBarrier}, step},
      .costs = &costs};
  StepSummary summary;
  Objective objective(system_, under);
  objective.add(inertia);
  std::optional<AirDrag> drag;
  if (options_.air) {
    drag.emplace(*options_.air, faces_, start, from.velocities, scheme.time);
    objective.add(*drag);
  }

  LedMotion led(from.configuration, end);
  const bool closed = led.has_arrived() && controls.bodies.empty();
  std::optional<Begin> begin = beginning(objective, end);
  if (begin) {
    led.go(1, begin->at);
  } else {
    end.positions = from.configuration.positions;
    begin = beginning(objective, end);
  }
  if (!begin) {
    to = from;
    return {.converged = false, .has_room = false, .residual = INFINITY, .costs = costs};
  }
  auto& [at, way] = *begin;
  // A scheme of two steps may lend energy to one and take it back in the next.
  const bool gains_nothing = closed && scheme.earlier == 0;
  const Trial trial{
      from,        under,         objective,
      inertia,     drag,          start,
      scheme.time, gains_nothing, coasting(system_.coordinates(), at, from.velocities, step, way)};
  if (options_.solve == StepSolve::linearized) {
    led.go(1, at);
    summary = linearized(trial, std::move(at), to);
  } else {
    summary = searched(trial, led, std::move(at), to);
  }
  summary.costs = costs;
  to.time = time;
  if (!summary.has_room) return summary;
  if (!to.configuration.positions.allFinite() || !std::isfinite(summary.residual)) {
    throw SolverError("the time step that ends at " + std::to_string(time) + " s",
                      summary.newton_iterations, summary.residual);
  }
  if (!closed || controls.vectors.size() > 0) {
    const Configuration& reached = to.configuration;
    summary.outside =
        outside_work(objective, reached, objective.gradient(reached), options_.schedule(from.time));
  }
  to.last_step = step;
  to.last_positions = from.configuration.positions;
  to.last_velocities = from.velocities;
  return summary;
}

StepSummary TimeStepper::advance(State& state, double step) {
  State next;
  const StepSummary summary = advance(state, step, next);
  if (summary.has_room) state = std::move(next);
  return summary;
}

}  // namespace pliant
