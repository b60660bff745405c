#pragma once

#include <optional>

#include "pliant/base/errors.h"
#include "pliant/io/fields.h"
#include "pliant/material/component_density.h"
#include "pliant/solver/integration.h"

namespace pliant {

enum class SimulationKind {
  dynamic,       ///< steps in time
  quasi_static,  ///< a path of equilibria; time is the parameter of the scene's motions alone
};

/// `time` of a scene/1 file.
struct Stepping {
  SimulationKind kind = SimulationKind::dynamic;
  double step = 0;      ///< s; of quasi-static paths: duration / steps
  double duration = 0;  ///< s
  Integrator integrator = Integrator::backward_euler;
  StepSolve solution = StepSolve::iterated;
  std::optional<FrictionForm> friction = FrictionForm::variational;  ///< nothing: left out
  bool adaptive = false;  ///< steps may be shortened where they fail
  /// Largest force left at a node of a converged step, N; `default_tolerance` where absent.
  std::optional<double> tolerance;
  /// An iterated step ends where no node moves further, m; `default_motion_tolerance` where absent.
  std::optional<double> motion_tolerance;
  double linear_tolerance = 1e-4;  ///< relative residual of a linearized step's equations
  Location where;

  /// Steps from 0 to the end; the last may end after `duration`, by less than a step.
  int step_count() const;
};

// What scenes and results call the ways to step.
const char* name_of(SimulationKind kind);
const char* name_of(Integrator integrator);
const char* name_of(StepSolve solution);
const char* name_of(const std::optional<FrictionForm>& friction);

/// @throws InputError
Stepping read_stepping(const Value& value);

}  // namespace pliant
