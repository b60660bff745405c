#include "pliant/experiment/tensile/strip_pull.h"

#include <algorithm>
#include <cmath>

#include "pliant/material/law_path.h"
#include "pliant/math/root.h"

namespace pliant {
namespace {

constexpr double kHighestPersistentStrain = 50;
constexpr double kRootStep = 0.01;

class StripWalk {
 public:
  StripWalk(const ComponentLaw& law, const UniaxialGeometry& geometry, const StripSetup& setup,
            const StripColumns& columns, int parameters)
      : law_(law),
        geometry_(geometry),
        setup_(setup),
        columns_(columns),
        parameters_(parameters),
        path_(law, {}) {
    geometry_.gauge_length += setup.rest_length_change;
    if (columns.rest_length_change < 0) return;
    rest_gradient_ = Eigen::VectorXd::Unit(parameters, columns.rest_length_change);
  }

  bool start(double length, double time) {
    const double strain = strain_at(geometry_, length);
    // A strip cannot push: where the stress at the start would, it is slack as well.
    slack_ = strain < 0 || start_stress(strain).stress < 0;
    std::optional<PathPoint> point;
    if (slack_) {
      point = slack_start();
    } else {
      const Pull pull = pulled(length, [&](double at) { return start_stress(at); });
      point = taut_start(pull.strain, pull.strain_gradient);
      remember(pull);
    }
    if (!point) return false;
    path_ = LawPath(law_, *point, time);
    last_strain_ = point->strain;
    return true;
  }

  // The same of a strip that was pulled before: it is slack at the strain that it kept.
  void start_after(const PathPoint& before, double length, double time) {
    measure_as_left(before);
    path_ = LawPath(law_, before, time);
    last_strain_ = before.strain;
    slack_ = strain_at(own_geometry(), length) <= before.strain;
    if (slack_) return;
    const Pull pull = pulled(length, [&](double strain) { return path_.at(strain, time); });
    go_to(pull, time);
    path_.turn_at(pull.strain, pull.strain_gradient);
  }

  // Takes the strip out of its clamps after the last half cycle.
  std::optional<PathPoint> released() {
    constexpr double kShortest = 0.5;  // of its length at rest
    if (slack_ && !law_.flows()) return path_.start();
    const double from = law_.flows() ? last_strain_ : path_.start().strain;
    const auto stress = [&](double strain) { return path_.stress_at(strain, kEndless); };
    slack_strain_ = from;
    if (stress(from) > 0) {
      slack_strain_ = first_root(stress, from, -kRootStep,
                                 strain_at(geometry_, kShortest * geometry_.gauge_length));
    }
    if (!slack_strain_) return std::nullopt;
    const Eigen::VectorXd gradient = kept_gradient(kEndless);
    if (law_.flows()) go_on(*slack_strain_, gradient, kEndless);
    path_.turn_at(*slack_strain_, gradient);
    return path_.start();
  }

  // Must be called before the rows of a half cycle: finds where it goes slack.
  void begin(const HalfCycle& half) {
    slack_strain_.reset();
    if (slack_) slack_strain_ = path_.start().strain;
    if (slack_ || half.direction == 1) return;
    const auto stress = [&](double strain) { return path_.stress_at(strain); };
    const double from = path_.start().strain;
    const double lowest = std::min(strain_at(own_geometry(), half.turn), from);
    if (stress(from) <= 0) {
      slack_strain_ = from;
    } else if (stress(lowest) < 0) {
      slack_strain_ = first_root(stress, from, -kRootStep, lowest);
    }
  }

  void row(const HalfCycle& half, double length, double time, Eigen::Index i, StripForces& out) {
    const double unloaded = strain_at(own_geometry(), length);
    if (law_.flows()) find_slack(unloaded, time);
    out.force(i) = setup_.force_offset + half.direction * setup_.apparatus_friction;
    out.length_gain(i) = 0;
    if (parameters_ > 0) out.jacobian.row(i).setZero();
    if (columns_.force_offset >= 0) out.jacobian(i, columns_.force_offset) = 1;
    if (slack_strain_ && unloaded < *slack_strain_) {
      out.strain(i) = *slack_strain_;
      last_force_ = 0;
      if (law_.flows()) go_on(*slack_strain_, kept_gradient(time), time);
      return;
    }
    const Pull pull = pulled(length, [&](double strain) { return path_.at(strain, time); });
    go_to(pull, time);
    out.strain(i) = pull.strain;
    out.force(i) += pull.force;
    out.length_gain(i) = std::abs(pull.by_length);
    if (parameters_ > 0) out.jacobian.row(i) += pull.force_gradient.transpose();
  }

  void end(const HalfCycle& half) {
    const bool ends_slack = slack_strain_ && strain_at(own_geometry(), half.turn) < *slack_strain_;
    if (!ends_slack) {
      const Pull turn = pulled(half.turn, [&](double strain) { return path_.at(strain); });
      remember(turn);
      path_.turn_at(turn.strain, turn.strain_gradient);
    } else if (!slack_ || law_.flows()) {
      path_.turn_at(*slack_strain_, kept_gradient(last_time_));
    }
    slack_ = ends_slack;
  }

 private:
  // What a strip does at a distance of the clamps.
  struct Pull {
    double strain = 0;
    double force = 0;      // N
    double by_length = 0;  // d force / d distance (N/m)
    Eigen::VectorXd strain_gradient, force_gradient;
  };

  // How strain follows from the length of the strip (l) and its rest length (r).
  struct Stretch {
    double strain = 0, by_length = 0, by_rest_length = 0;
  };

  // The geometry with what has slipped out of the clamps so far.
  UniaxialGeometry own_geometry() const {
    UniaxialGeometry own = geometry_;
    own.gauge_length += setup_.slip * largest_force_;
    return own;
  }

  Stretch stretched(double length, double force) const {
    UniaxialGeometry own = geometry_;
    own.gauge_length += setup_.slip * std::max(force, largest_force_);
    const double strip = length - setup_.compliance * force;
    const double slope = strain_slope(own, strip);
    return {strain_at(own, strip), slope, -strip / own.gauge_length * slope};
  }

  // How fast strain falls where force grows, both by slip and by compliance.
  double yield_at(const Stretch& stretch, bool slips) const {
    return setup_.compliance * stretch.by_length -
           (slips ? setup_.slip * stretch.by_rest_length : 0.0);
  }

  // Solves force = f(strain(force)) by Newton's method; f is nearly linear over what the apparatus
  // gives way.
  template <class StressAt>
  Pull pulled(double length, const StressAt& stress_at) const {
    constexpr int kMostSteps = 30;
    constexpr double kExactShare = 1e-12;
    const bool gives_way = setup_.slip != 0 || setup_.compliance != 0;
    Pull pull;
    pull.force = gives_way ? last_force_ : 0;
    for (int step = 0;; ++step) {
      const Stretch stretch = stretched(length, pull.force);
      const PathStress here = stress_at(stretch.strain);
      const double factor = force_factor(geometry_, stretch.strain);
      const double force = factor * here.stress;
      const double slope =
          factor * here.slope + force_factor_slope(geometry_, stretch.strain) * here.stress;
      const bool slips = pull.force > largest_force_;
      const double share = 1 + slope * yield_at(stretch, slips);
      const double change = (force - pull.force) / share;
      const bool done = !gives_way || step == kMostSteps ||
                        std::abs(change) <= kExactShare * (std::abs(force) + last_force_);
      if (!done) {
        pull.force += change;
        continue;
      }
      pull.strain = stretch.strain;
      pull.force = force;
      pull.by_length = slope * stretch.by_length / share;
      if (parameters_ > 0) differentiate(pull, stretch, factor * here.gradient, slope, slips);
      return pull;
    }
  }

  // Derivatives of force and strain by the parameters.
  // @param at_strain  d force / d parameters while the strain stays
  void differentiate(Pull& pull, const Stretch& stretch, const Eigen::VectorXd& at_strain,
                     double slope, bool slips) const {
    // d strain / d parameters while the force stays
    Eigen::VectorXd at_force = Eigen::VectorXd::Zero(parameters_);
    const auto add = [&](int column, double by) {
      if (column >= 0) at_force(column) += by;
    };
    const double largest = std::max(pull.force, largest_force_);
    if (rest_gradient_.size() > 0) at_force += stretch.by_rest_length * rest_gradient_;
    add(columns_.slip, stretch.by_rest_length * largest);
    add(columns_.compliance, -stretch.by_length * pull.force);
    if (!slips && largest_gradient_.size() > 0) {
      at_force += setup_.slip * stretch.by_rest_length * largest_gradient_;
    }
    const double yield = yield_at(stretch, slips);
    pull.force_gradient = (at_strain + slope * at_force) / (1 + slope * yield);
    pull.strain_gradient = at_force - yield * pull.force_gradient;
  }

  void remember(const Pull& pull) {
    last_force_ = pull.force;
    if (pull.force <= largest_force_) return;
    largest_force_ = pull.force;
    largest_gradient_ = pull.force_gradient;
  }

  void go_to(const Pull& pull, double time) {
    if (law_.flows()) go_on(pull.strain, pull.strain_gradient, time);
    remember(pull);
  }

  // The stated length is that of the strip as it was left: the strain that it keeps is part of it.
  void measure_as_left(const PathPoint& before) {
    const UniaxialGeometry unit{1, 1, geometry_.measure};
    const double stretch = length_at(unit, before.strain);
    geometry_.gauge_length /= stretch;
    if (parameters_ == 0) return;
    if (rest_gradient_.size() == 0) rest_gradient_ = Eigen::VectorXd::Zero(parameters_);
    rest_gradient_ /= stretch;
    rest_gradient_ -=
        geometry_.gauge_length / (stretch * strain_slope(unit, stretch)) * before.strain_gradient;
  }

  // Stress at the first row, of elasticity and the initial state of friction.
  PathStress start_stress(double strain) const {
    PathStress stress;
    stress.stress =
        law_.elastic_stress(strain) + setup_.initial_friction * law_.max_friction(strain);
    stress.slope = law_.elastic_tangent(strain) + friction_slope();
    if (parameters_ > 0) {
      stress.gradient = friction_gradient(strain);
      law_.add_elastic_gradient(strain, stress.gradient);
    }
    return stress;
  }

  // What flows lets go while the strip is slack: it is where the stress is zero by now.
  void find_slack(double strain, double time) {
    const auto stress = [&](double at) { return path_.stress_at(at, time); };
    slack_strain_.reset();
    if (stress(strain) >= 0) return;
    if (strain >= last_strain_ || stress(last_strain_) <= 0) {
      slack_strain_ = std::max(strain, last_strain_);
    } else {
      slack_strain_ = first_root(stress, last_strain_, -kRootStep, strain);
    }
  }

  // The stress stays zero there whatever the parameters: d strain = -d stress / slope.
  Eigen::VectorXd kept_gradient(double time) const {
    if (slack_ && !law_.flows()) return path_.start().strain_gradient;
    const PathStress here = path_.at(*slack_strain_, time);
    return -here.gradient / here.slope;
  }

  void go_on(double strain, const Eigen::VectorXd& gradient, double time) {
    path_.pass(strain, gradient, time);
    last_strain_ = strain;
    last_time_ = time;
  }

  // Derivatives of ratio * max_friction(strain) at fixed strain.
  Eigen::VectorXd friction_gradient(double strain) const {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(parameters_);
    if (parameters_ == 0 || law_.friction_count() == 0) return gradient;
    gradient(law_.stiffness.size()) = setup_.initial_friction;
    gradient(law_.stiffness.size() + 1) = setup_.initial_friction * std::abs(strain);
    if (columns_.initial_friction >= 0) {
      gradient(columns_.initial_friction) = law_.max_friction(strain);
    }
    return gradient;
  }

  double friction_slope() const {
    return law_.friction_count() == 0 ? 0 : setup_.initial_friction * law_.friction[1];
  }

  std::optional<PathPoint> taut_start(double strain, const Eigen::VectorXd& gradient) const {
    return PathPoint{strain, setup_.initial_friction * law_.max_friction(strain), gradient,
                     friction_gradient(strain) + friction_slope() * gradient};
  }

  // A slack strip keeps the strain at which elastic and friction stress cancel.
  std::optional<PathPoint> slack_start() const {
    const double ratio = setup_.initial_friction;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(parameters_);
    if (ratio >= 0 || law_.friction_count() == 0) return PathPoint{0, 0, zero, zero};
    const auto total = [&](double strain) {
      return law_.elastic_stress(strain) + ratio * law_.max_friction(strain);
    };
    const auto strain = first_root(total, 0, kRootStep, kHighestPersistentStrain);
    if (!strain) return std::nullopt;
    if (parameters_ == 0) return taut_start(*strain, zero);
    const PathStress stress = start_stress(*strain);
    return taut_start(*strain, -stress.gradient / stress.slope);
  }

  ComponentLaw law_;
  UniaxialGeometry geometry_;      // with the strip's own rest length
  Eigen::VectorXd rest_gradient_;  // of that length by the parameters; empty: it hangs on none
  StripSetup setup_;
  StripColumns columns_;
  int parameters_;
  LawPath path_;
  double last_strain_ = 0, last_time_ = 0, last_force_ = 0;  // of the row before
  double largest_force_ = 0;
  Eigen::VectorXd largest_gradient_;
  bool slack_ = false;
  std::optional<double>
      slack_strain_;  // kept by the material while the present half cycle is slack
};

/// Follows the clamps; false where the strip's start has no value.
bool follow(StripWalk& walk, std::span<const double> lengths,
            std::span<const HalfCycle> half_cycles, std::span<const double> times,
            const PathPoint* before, StripForces& out) {
  const auto time = [&](int i) { return times.empty() ? kEndless : times[static_cast<size_t>(i)]; };
  if (before) {
    walk.start_after(*before, lengths.front(), time(0));
  } else if (!walk.start(lengths.front(), time(0))) {
    return false;
  }
  for (const HalfCycle& half : half_cycles) {
    walk.begin(half);
    for (int i = half.first; i <= half.last; ++i) {
      walk.row(half, lengths[static_cast<size_t>(i)], time(i), i, out);
    }
    walk.end(half);
  }
  return true;
}

StripForces rows_of_forces(std::span<const double> lengths, int parameters) {
  const auto rows = static_cast<Eigen::Index>(lengths.size());
  return {Eigen::VectorXd(rows), Eigen::VectorXd(rows), Eigen::VectorXd(rows),
          Eigen::MatrixXd(rows, parameters)};
}

}  // namespace

std::optional<StripForces> pull_strip(const ComponentLaw& law, const UniaxialGeometry& geometry,
                                      const StripSetup& setup, const StripColumns& columns,
                                      std::span<const double> lengths,
                                      std::span<const HalfCycle> half_cycles, int parameters,
                                      std::span<const double> times, const PathPoint* before) {
  StripForces out = rows_of_forces(lengths, parameters);
  StripWalk walk(law, geometry, setup, columns, parameters);
  if (!follow(walk, lengths, half_cycles, times, before, out)) return std::nullopt;
  return out;
}

std::optional<PathPoint> state_after_pull(const ComponentLaw& law, const UniaxialGeometry& geometry,
                                          const StripSetup& setup, std::span<const double> lengths,
                                          std::span<const HalfCycle> half_cycles, int parameters,
                                          std::span<const double> times, const PathPoint* before) {
  StripForces out = rows_of_forces(lengths, parameters);
  StripWalk walk(law, geometry, setup, {}, parameters);
  if (!follow(walk, lengths, half_cycles, times, before, out)) return std::nullopt;
  return walk.released();
}

}  // namespace pliant
