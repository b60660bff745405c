#include "pliant/scene/simulation.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/geometry/mesh_quality.h"
#include "pliant/scene/met_bodies.h"
#include "pliant/solver/static_path.h"
#include "pliant/solver/time_stepper.h"

namespace pliant {

struct Simulation::StepResult {
  int substeps = 0;
  int newton_iterations = 0;
  int linear_iterations = 0;
  double work = 0;     // against friction, damping and air (J)
  double drag = 0;     // of it, against the air
  double rubbing = 0;  // of it, against the friction of contacts
  double outside = 0;  // done by what is moved from outside (J)
  SearchCosts costs = {};
};

/// Takes a simulation's state through one step.
class Simulation::Stepper {
 public:
  virtual ~Stepper() = default;
  /// @throws SolverError; `state` is then as it was
  virtual StepResult advance(State& state) = 0;
};

namespace {

// 10 uN ([T] 3.4.1), but never more than a thousandth of what a node weighs on earth: with more, a
// fine mesh would not notice gravity.
double default_tolerance(const System& system) {
  constexpr double kOfThesis = 1e-5, kOfWeight = 1e-3;
  const auto heavy = (system.masses().array() > 0).count();  // all but vertices of bodies
  const double weight = kStandardGravity * system.masses().sum() / static_cast<double>(heavy);
  return heavy > 0 ? std::min(kOfThesis, kOfWeight * weight) : kOfThesis;
}

// 30 um, but never more than a 300th of the mean edge of a cloth or a solid's surface: with more,
// strains of a fine mesh would tremble from step to step, and what friction holds would be lost to
// it. Where something may be met never more than a hundredth of what a step adds to a free fall:
// contacts give way under a weight by a quarter of that, and what slides is braked by what is left
// too deep.
double default_motion_tolerance(const Scene& scene, const SceneSystem& built) {
  constexpr double kMost = 3e-5, kOfEdge = 1.0 / 300, kOfFall = 0.01;
  double tolerance = kMost;
  if (built.surface_contact || !built.obstacle_contacts.empty()) {
    const double fall = kStandardGravity * scene.time.step * scene.time.step;
    tolerance = std::min(kMost, kOfFall * fall);
  }
  for (const ClothPiece& cloth : built.cloths) {
    tolerance = std::min(tolerance, kOfEdge * mesh_quality(cloth.mesh).mean_edge);
  }
  for (const SolidPiece& solid : built.solids) {
    tolerance = std::min(tolerance, kOfEdge * solid.edge_lengths().mean);
  }
  return tolerance;
}

TimeStepOptions time_step_options(const Scene& scene, const SceneSystem& built) {
  TimeStepOptions options;
  options.schedule = built.schedule;
  options.step = scene.time.step;
  options.integrator = scene.time.integrator;
  options.solve = scene.time.solution;
  options.tolerance = scene.time.tolerance.value();
  options.motion_tolerance = scene.time.motion_tolerance.value();
  options.linear_tolerance = scene.time.linear_tolerance;
  // As published ([T] 5.4) a step is never solved again.
  options.mend_growth = scene.time.friction != FrictionForm::linearized;
  options.air = scene.air;
  return options;
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

class Simulation::TimeSteps : public Simulation::Stepper {
 public:
  TimeSteps(const Scene& scene, const SceneSystem& built)
      : scene_(scene),
        built_(built),
        adaptive_(scene.time.adaptive),
        stepper_(*built.system, time_step_options(scene, built), built.faces),
        step_(scene.time.step) {}

  StepResult advance(State& state) override {
    StepResult result;
    advance(state, step_, 0, result);
    return result;
  }

 private:
  // With `adaptive`, a step that fails is taken as two of half its size, and always one that gains
  // energy from nowhere, down to a sixteenth. Where a half fails, the state is as it was.
  void advance(State& state, double step, int halvings, StepResult& result) {
    constexpr int kMostHalvings = 8, kMostOfGain = 4;
    const StepSummary summary = attempt(state, step);
    result.newton_iterations += summary.newton_iterations;
    result.linear_iterations += summary.linear_iterations;
    result.costs += summary.costs;
    const bool halved = summary.gained && halvings < kMostOfGain;
    if (summary.converged && !halved) {
      ++result.substeps;
      result.work += summary.work + summary.drag;
      result.drag += summary.drag;
      result.rubbing += summary.rubbing;
      result.outside += summary.outside;
      std::swap(state, next_);
      return;
    }
    if (!halved && (!adaptive_ || halvings == kMostHalvings)) {
      throw SolverError(failure_of(state.time + step, summary.has_room), summary.newton_iterations,
                        summary.residual);
    }
    const State begun = state;
    try {
      for (int half = 0; half < 2; ++half) advance(state, step / 2, halvings + 1, result);
    } catch (...) {
      state = begun;
      throw;
    }
  }

  // By what is nearest to the cloth where the step came to.
  std::string failure_of(double time, bool has_room) const {
    std::string text = fmt::format("the step to {:.6g} s", time);
    const size_t at_least = has_room ? 0 : 2;  // it takes two to leave no room
    const std::string nearest = nearest_text(met_bodies(scene_, built_, next_), at_least);
    if (!has_room) text += ", in which what is led leaves what it meets no room";
    if (!nearest.empty()) text += (has_room ? ", where " : ": ") + nearest;
    return has_room && nearest.empty() ? text : text + ",";
  }

  // Takes `next_` where a step leads, or where it came to.
  StepSummary attempt(const State& state, double step) {
    try {
      return stepper_.advance(state, step, next_);
    } catch (const SolverError& error) {
      next_ = state;
      return {.converged = false,
              .newton_iterations = error.iterations(),
              .residual = error.best_residual()};
    }
  }

  const Scene& scene_;
  const SceneSystem& built_;
  bool adaptive_;
  TimeStepper stepper_;
  double step_;
  State next_;
};

class Simulation::Equilibria : public Simulation::Stepper {
 public:
  Equilibria(const Scene& scene, const SceneSystem& built)
      : path_(*built.system, options(scene, built), built.start), step_(scene.time.step) {}

  StepResult advance(State& state) override {
    path_.go_on_from(state);
    const PathEquilibrium point = path_.step(state.time + step_);
    state = path_.state();
    return {.substeps = point.equilibria,
            .newton_iterations = point.newton.iterations,
            .linear_iterations = point.newton.linear_iterations,
            .work = point.work,
            .outside = point.outside,
            .costs = point.costs};
  }

 private:
  static StaticPathOptions options(const Scene& scene, const SceneSystem& built) {
    StaticPathOptions options;
    options.schedule = built.schedule;
    options.newton.tolerance = scene.time.tolerance.value();
    return options;
  }

  StaticPath path_;
  double step_;
};

Simulation::Simulation(const Scene& scene, const std::optional<Material>& filler, int threads)
    : scene_(scene), threads_(threads), built_(build_scene(scene, filler)) {
  if (!scene_.time.tolerance) scene_.time.tolerance = default_tolerance(*built_.system);
  if (!scene_.time.motion_tolerance) {
    scene_.time.motion_tolerance = default_motion_tolerance(scene, built_);
  }
  if (scene_.time.kind == SimulationKind::dynamic) {
    stepper_ = std::make_unique<TimeSteps>(scene_, built_);
  } else {
    stepper_ = std::make_unique<Equilibria>(scene_, built_);
  }
  now_.state = built_.start;
}

Simulation::~Simulation() = default;

bool Simulation::is_frame() const {
  return now_.steps % steps_per_frame(scene_.output, scene_.time) == 0 || is_finished();
}

bool Simulation::is_recorded() const {
  return !now_.energies.empty() && now_.energies.back().time == now_.state.time;
}

void Simulation::resume(SimulationState state) {
  now_ = std::move(state);
  // The last frame of a shorter run may stand where this one has none.
  if (!is_recorded() || is_frame()) return;
  now_.energies.pop_back();
  now_.clips.resize(now_.clips.size() - built_.start.configuration.clips.size());
}

void Simulation::record_frame() {
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, built_.system->points());
  Derivatives derivatives;
  derivatives.gradient = &gradient;
  const Controls controls = built_.schedule(now_.state.time);
  built_.system->evaluate(now_.state.configuration, {.from = now_.state, .controls = controls},
                          Curvature::exact, derivatives);
  record_energy(derivatives.energy);
  record_clips(gradient);
}

void Simulation::record_energy(const Energy& energy) {
  EnergyRow row;
  row.time = now_.state.time;
  row.kinetic = now_.state.velocities.colwise().squaredNorm().dot(built_.system->masses()) / 2;
  row.stored = energy.stored;
  row.work = now_.work;
  row.drag = now_.drag;
  row.contact = energy.contact;
  row.rubbing = now_.rubbing;
  row.outside = now_.outside;
  now_.energies.push_back(row);
}

void Simulation::record_clips(const Eigen::Matrix3Xd& gradient) {
  const Configuration& start = built_.start.configuration;
  for (size_t k = 0; k < start.clips.size(); ++k) {
    const Pose& pose = now_.state.configuration.clips[k];
    const Eigen::Vector3d shift = pose.translation - pose.rotation * start.clips[k].translation;
    const Eigen::Quaterniond& turn = pose.rotation;
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (const int point : built_.system->coordinates().clip_points(static_cast<int>(k))) {
      force += gradient.col(point);
    }
    now_.clips.push_back({{shift.x(), shift.y(), shift.z()},
                          {turn.w(), turn.x(), turn.y(), turn.z()},
                          {force.x(), force.y(), force.z()}});
  }
}

void Simulation::advance() {
  const double begin = seconds_now();
  StepResult result;
  with_threads(threads_, [&] { result = stepper_->advance(now_.state); });
  ++now_.steps;
  // Not a sum of steps, which would drift.
  now_.state.time = now_.steps * scene_.time.step;
  now_.work += result.work;
  now_.drag += result.drag;
  now_.rubbing += result.rubbing;
  now_.outside += result.outside;
  now_.records.seconds.push_back(seconds_now() - begin);
  now_.records.costs.push_back(result.costs);
  now_.records.substeps.push_back(result.substeps);
  now_.records.newton_iterations.push_back(result.newton_iterations);
  now_.records.linear_iterations.push_back(result.linear_iterations);
  record_contacts();
}

void Simulation::record_contacts() {
  const auto bodies = met_bodies(scene_, built_, now_.state);
  if (bodies.empty()) return;
  int count = 0;
  for (const MetBody& body : bodies) count += body.touching.count;
  now_.records.contacts.push_back(count);
  now_.records.distances.push_back(bodies.front().touching.least_distance);
}

}  // namespace pliant
