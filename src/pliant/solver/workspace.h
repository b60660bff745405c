#pragma once

#include <memory>

#include "pliant/math/linear_solver.h"
#include "pliant/mechanics/system.h"

namespace pliant {

/// Room for one search at a time on a system: its Hessian and a solver of equations with that. The
/// system itself is constant, and may serve many workspaces at once.
struct Workspace {
  Hessian hessian;
  std::unique_ptr<LinearSolver> solver;

  /// With a sparse Cholesky factor.
  /// @param system  outlives the workspace
  explicit Workspace(const System& system);
  Workspace(Hessian room, std::unique_ptr<LinearSolver> of)
      : hessian(std::move(room)), solver(std::move(of)) {}

  /// For another thread; what was found out about the pattern of the Hessian is shared.
  Workspace another() const { return {hessian, solver->another()}; }
};

}  // namespace pliant
