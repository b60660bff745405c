#include "pliant/scene/stepping.h"

#include <cmath>

#include <fmt/format.h>

namespace pliant {
namespace {

constexpr int kMostSteps = 100'000'000;

// Units leave rounding: 2 s are 400 steps of 5 ms.
constexpr double kRounding = 1e-6;

std::string time_text(double time) { return format_quantity(time, Dimension::time); }

void read_step(Fields& fields, Stepping& stepping) {
  const Value step = fields.require("step"), duration = fields.require("duration");
  stepping.step = step.positive_quantity(Dimension::time);
  stepping.duration = duration.positive_quantity(Dimension::time);
  if (stepping.duration <= stepping.step) {
    duration.fail(fmt::format("{} is not longer than the step", time_text(stepping.duration)),
                  "more than " + time_text(stepping.step));
  }
  if (stepping.duration / stepping.step > kMostSteps) {
    step.fail(fmt::format("makes about {:.2g} steps", stepping.duration / stepping.step),
              fmt::format("at most {}", kMostSteps));
  }
}

// A file that states the forces that a step may leave, and not how it is solved, is an old one: it
// means steps that converge.
StepSolve read_solution(Fields& fields) {
  const auto v = fields.optional("solve");
  if (!v) return fields.optional("tolerance") ? StepSolve::converged : StepSolve::iterated;
  const std::string solution = v->choice({"linearized", "iterated", "converged"});
  if (solution == "linearized") return StepSolve::linearized;
  return solution == "iterated" ? StepSolve::iterated : StepSolve::converged;
}

void read_dynamic(Fields& fields, Stepping& stepping) {
  read_step(fields, stepping);
  if (auto v = fields.optional("integrator")) {
    stepping.integrator = v->choice({"backward-euler", "bdf2"}) == "bdf2"
                              ? Integrator::bdf2
                              : Integrator::backward_euler;
  }
  stepping.solution = read_solution(fields);
  if (auto v = fields.optional("adaptive")) stepping.adaptive = v->flag();
}

void read_quasi_static(Fields& fields, Stepping& stepping) {
  stepping.solution = StepSolve::converged;
  const int steps = fields.require("steps").integer(1, kMostSteps);
  stepping.duration = fields.require("duration").positive_quantity(Dimension::time);
  stepping.step = stepping.duration / steps;
}

std::optional<FrictionForm> friction_named(const std::string& name) {
  if (name == "none") return std::nullopt;
  return name == "linearized" ? FrictionForm::linearized : FrictionForm::variational;
}

void read_tolerance(Fields& fields, Stepping& stepping) {
  if (stepping.solution == StepSolve::converged) {
    if (auto v = fields.optional("tolerance")) {
      stepping.tolerance = v->positive_quantity(Dimension::force);
    }
  } else if (stepping.solution == StepSolve::iterated) {
    if (auto v = fields.optional("motion_tolerance")) {
      stepping.motion_tolerance = v->positive_quantity(Dimension::length);
    }
  } else if (auto v = fields.optional("linear_tolerance")) {
    stepping.linear_tolerance = v->number();
    if (stepping.linear_tolerance <= 0 || stepping.linear_tolerance >= 1) {
      v->fail("is out of range", "a number between 0 and 1");
    }
  }
}

}  // namespace

int Stepping::step_count() const {
  return static_cast<int>(std::ceil(duration / step * (1 - kRounding)));
}

const char* name_of(SimulationKind kind) {
  return kind == SimulationKind::dynamic ? "dynamic" : "quasi-static";
}

const char* name_of(Integrator integrator) {
  return integrator == Integrator::bdf2 ? "bdf2" : "backward-euler";
}

const char* name_of(StepSolve solution) {
  switch (solution) {
    case StepSolve::linearized:
      return "linearized";
    case StepSolve::iterated:
      return "iterated";
    case StepSolve::converged:
      break;
  }
  return "converged";
}

const char* name_of(const std::optional<FrictionForm>& friction) {
  if (!friction) return "none";
  return *friction == FrictionForm::linearized ? "linearized" : "variational";
}

Stepping read_stepping(const Value& value) {
  Fields fields = value.fields();
  Stepping stepping;
  stepping.where = value.location();
  if (auto v = fields.optional("kind")) {
    stepping.kind = v->choice({"dynamic", "quasi-static"}) == "dynamic"
                        ? SimulationKind::dynamic
                        : SimulationKind::quasi_static;
  }
  if (stepping.kind == SimulationKind::dynamic) {
    read_dynamic(fields, stepping);
  } else {
    read_quasi_static(fields, stepping);
  }
  if (auto v = fields.optional("friction")) {
    stepping.friction = friction_named(v->choice({"variational", "linearized", "none"}));
  }
  read_tolerance(fields, stepping);
  fields.finish();
  return stepping;
}

}  // namespace pliant
