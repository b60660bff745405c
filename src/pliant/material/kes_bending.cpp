#include "pliant/material/kes_bending.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/law_path.h"
#include "pliant/math/root.h"

namespace pliant {
namespace {

constexpr double kReach = kStrainPerCurvature * kKesLargestCurvature;

/// The law without friction, whose parameters hang on the side of zero.
ComponentLaw without_friction(const MaterialComponent& component) {
  ComponentLaw law = law_of(component);
  law.friction_law = FrictionLaw::none;
  return law;
}

/// Moment per width on the two branches of the closed loop.
class ClosedLoop {
 public:
  explicit ClosedLoop(const MaterialComponent& component)
      : lower_turn_{LawPath(without_friction(component), {-kReach, 0, {}, {}}), {-kReach, 0}},
        upper_turn_(lower_turn_) {
    if (component.friction) {
      const ComponentFriction& friction = *component.friction;
      friction_ = {friction.positive, friction.negative.value_or(friction.positive)};
    }
    close();
  }

  double loading(double curvature) const { return moment(curvature, lower_turn_); }
  double unloading(double curvature) const { return moment(curvature, upper_turn_); }

 private:
  struct Turn {
    LawPath others;  // what is no friction
    FrictionState friction;

    double remembered() const {
      return std::abs(friction.stress) + others.start().history.lpNorm<1>();
    }
  };

  double friction_at(double strain, const FrictionState& from) const {
    return friction_ ? friction_stress(*friction_, strain, from).friction.stress : 0;
  }

  double moment(double curvature, const Turn& from) const {
    const double strain = kStrainPerCurvature * curvature;
    return from.others.stress_at(strain) + friction_at(strain, from.friction);
  }

  Turn turned(Turn from, double strain) const {
    from.others.turn_at(strain, {});
    from.friction = {strain, friction_at(strain, from.friction)};
    return from;
  }

  // What is left of the start shrinks by exp(-2 reach / tau) a half cycle.
  void close() {
    constexpr int kMostCycles = 10000;
    constexpr double kClosed = 1e-14;
    for (int cycle = 0; cycle < kMostCycles; ++cycle) {
      const double before = lower_turn_.remembered();
      upper_turn_ = turned(lower_turn_, kReach);
      lower_turn_ = turned(upper_turn_, -kReach);
      const double after = lower_turn_.remembered();
      if (std::abs(after - before) <= kClosed * after) return;
    }
  }

  std::optional<DahlBySide> friction_;
  Turn lower_turn_, upper_turn_;
};

// On the side of positive (1) or negative (-1) curvature: the mean of its two branches.
double mean_slope(const ClosedLoop& loop, double side) {
  const auto [from, to] = kKesSlopeCurvature;
  const auto rise = [&](double curvature) {
    return loop.loading(side * curvature) + loop.unloading(side * curvature);
  };
  return side * (rise(to) - rise(from)) / (2 * (to - from));
}

// The moment that the way back from the turn leaves over, counted in the sense of the side.
std::optional<double> residual(const ClosedLoop& loop, double side) {
  const auto moment = [&](double curvature) {
    return side > 0 ? loop.unloading(curvature) : -loop.loading(-curvature);
  };
  constexpr double kSteps = 2000;
  if (moment(kKesLargestCurvature) <= 0) return std::nullopt;
  return first_root(moment, kKesLargestCurvature, -kKesLargestCurvature / kSteps, 0);
}

}  // namespace

KesBending kes_bending(const MaterialComponent& component) {
  PLIANT_ASSERT(component.stiffness.has_value(), "a component with numbers");
  const ClosedLoop loop(component);
  KesBending result;
  result.rigidity = (mean_slope(loop, 1) + mean_slope(loop, -1)) / 2;
  for (const double side : {1.0, -1.0}) {
    const double curvature = side * kKesHysteresisCurvature;
    result.hysteresis += (loop.loading(curvature) - loop.unloading(curvature)) / 2;
  }
  const std::optional<double> right = residual(loop, 1), left = residual(loop, -1);
  if (right && left) result.residual_curvature = (*right + *left) / 2;
  return result;
}

}  // namespace pliant
