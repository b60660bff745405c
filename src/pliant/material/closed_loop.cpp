#include "pliant/material/closed_loop.h"

#include <cmath>
#include <utility>

namespace pliant {
namespace {

/// The law without friction, whose parameters hang on the side of zero.
ComponentLaw without_friction(const MaterialComponent& component) {
  ComponentLaw law = law_of(component);
  law.friction_law = FrictionLaw::none;
  return law;
}

}  // namespace

ClosedLoop::ClosedLoop(const MaterialComponent& component, double reach)
    : reach_(reach),
      lower_turn_{LawPath(without_friction(component), {-reach, 0, {}, {}}), {-reach, 0}},
      upper_turn_(lower_turn_) {
  if (component.friction) {
    const ComponentFriction& friction = *component.friction;
    friction_ = {friction.positive, friction.negative.value_or(friction.positive)};
  }
  close();
}

double ClosedLoop::Turn::remembered() const {
  return std::abs(friction.stress) + others.start().history.lpNorm<1>();
}

double ClosedLoop::friction_at(double strain, const FrictionState& from) const {
  return friction_ ? friction_stress(*friction_, strain, from).friction.stress : 0;
}

double ClosedLoop::stress(double strain, const Turn& from) const {
  return from.others.stress_at(strain) + friction_at(strain, from.friction);
}

ClosedLoop::Turn ClosedLoop::turned(Turn from, double strain) const {
  from.others.turn_at(strain, {});
  from.friction = {strain, friction_at(strain, from.friction)};
  return from;
}

// What is left of the start shrinks by exp(-2 reach / tau) a half cycle.
void ClosedLoop::close() {
  constexpr int kMostCycles = 10000;
  constexpr double kClosed = 1e-14;
  for (int cycle = 0; cycle < kMostCycles; ++cycle) {
    const double before = lower_turn_.remembered();
    upper_turn_ = turned(lower_turn_, reach_);
    lower_turn_ = turned(upper_turn_, -reach_);
    const double after = lower_turn_.remembered();
    if (std::abs(after - before) <= kClosed * after) return;
  }
}

}  // namespace pliant
