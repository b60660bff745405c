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
  }

  bool start(double length, double time) {
    const double strain = strain_at(geometry_, length);
    // A strip cannot push: where the stress at the start would, it is slack as well.
    slack_ = strain < 0 ||
             law_.elastic_stress(strain) + setup_.initial_friction * law_.max_friction(strain) < 0;
    const auto point = slack_ ? slack_start() : taut_start(strain, strain_gradient(length));
    if (!point) return false;
    path_ = LawPath(law_, *point, time);
    last_strain_ = point->strain;
    return true;
  }

  // Must be called before the rows of a half cycle: finds where it goes slack.
  void begin(const HalfCycle& half) {
    slack_strain_.reset();
    if (slack_) slack_strain_ = path_.start().strain;
    if (slack_ || half.direction == 1) return;
    const auto stress = [&](double strain) { return path_.stress_at(strain); };
    const double from = path_.start().strain;
    const double lowest = std::min(strain_at(geometry_, half.turn), from);
    if (stress(from) <= 0) {
      slack_strain_ = from;
    } else if (stress(lowest) < 0) {
      slack_strain_ = first_root(stress, from, -kRootStep, lowest);
    }
  }

  void row(const HalfCycle& half, double length, double time, Eigen::Index i, StripForces& out) {
    const double strain = strain_at(geometry_, length);
    if (law_.flows()) find_slack(strain, time);
    out.force(i) = setup_.force_offset + half.direction * setup_.apparatus_friction;
    out.length_gain(i) = 0;
    if (parameters_ > 0) out.jacobian.row(i).setZero();
    if (columns_.force_offset >= 0) out.jacobian(i, columns_.force_offset) = 1;
    if (slack_strain_ && strain < *slack_strain_) {
      out.strain(i) = *slack_strain_;
      if (law_.flows()) go_on(*slack_strain_, kept_gradient(time), time);
      return;
    }
    const PathStress here = path_.at(strain, time);
    if (law_.flows()) go_on(strain, strain_gradient(length), time);
    const double factor = force_factor(geometry_, strain);
    const double slope = factor * here.slope + force_factor_slope(geometry_, strain) * here.stress;
    out.strain(i) = strain;
    out.force(i) += factor * here.stress;
    out.length_gain(i) = std::abs(slope * strain_slope(geometry_, length));
    if (parameters_ == 0) return;
    out.jacobian.row(i) += factor * here.gradient.transpose();
    if (columns_.rest_length_change >= 0) {
      out.jacobian(i, columns_.rest_length_change) += slope * strain_by_rest_length(length);
    }
  }

  void end(const HalfCycle& half) {
    const double turn = strain_at(geometry_, half.turn);
    const bool ends_slack = slack_strain_ && turn < *slack_strain_;
    if (!ends_slack) {
      path_.turn_at(turn, strain_gradient(half.turn));
    } else if (!slack_ || law_.flows()) {
      path_.turn_at(*slack_strain_, kept_gradient(last_time_));
    }
    slack_ = ends_slack;
  }

 private:
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

  double strain_by_rest_length(double length) const {
    return -length / geometry_.gauge_length * strain_slope(geometry_, length);
  }

  Eigen::VectorXd strain_gradient(double length) const {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(parameters_);
    if (columns_.rest_length_change >= 0) {
      gradient(columns_.rest_length_change) = strain_by_rest_length(length);
    }
    return gradient;
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
    Eigen::VectorXd gradient = friction_gradient(*strain);
    if (parameters_ > 0) {
      gradient.head(law_.parameter_count()) += law_.elastic_gradient(*strain);
      gradient /= -(law_.elastic_tangent(*strain) + friction_slope());
    }
    return taut_start(*strain, gradient);
  }

  ComponentLaw law_;
  UniaxialGeometry geometry_;  // with the strip's own rest length
  StripSetup setup_;
  StripColumns columns_;
  int parameters_;
  LawPath path_;
  double last_strain_ = 0, last_time_ = 0;  // of the row before
  bool slack_ = false;
  std::optional<double>
      slack_strain_;  // kept by the material while the present half cycle is slack
};

}  // namespace

std::optional<StripForces> pull_strip(const ComponentLaw& law, const UniaxialGeometry& geometry,
                                      const StripSetup& setup, const StripColumns& columns,
                                      std::span<const double> lengths,
                                      std::span<const HalfCycle> half_cycles, int parameters,
                                      std::span<const double> times) {
  const auto rows = static_cast<Eigen::Index>(lengths.size());
  StripForces out{Eigen::VectorXd(rows), Eigen::VectorXd(rows), Eigen::VectorXd(rows),
                  Eigen::MatrixXd(rows, parameters)};
  StripWalk walk(law, geometry, setup, columns, parameters);
  const auto time = [&](int i) { return times.empty() ? kEndless : times[static_cast<size_t>(i)]; };
  if (!walk.start(lengths.front(), time(0))) return std::nullopt;
  for (const HalfCycle& half : half_cycles) {
    walk.begin(half);
    for (int i = half.first; i <= half.last; ++i) {
      walk.row(half, lengths[static_cast<size_t>(i)], time(i), i, out);
    }
    walk.end(half);
  }
  return out;
}

}  // namespace pliant
