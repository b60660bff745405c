#pragma once

#include "pliant/solver/newton.h"

namespace pliant {

/// Equilibria of a system by Newton's method on a sparse Cholesky factor whose symbolic analysis is
/// done once ([T] 3.4.1). The system may serve other solvers at the same time.
class StaticSolver {
 public:
  /// @param system  outlives the solver
  explicit StaticSolver(const System& system,
                        const NewtonOptions& options = {.reuse_factor = true});

  /// Moves the configuration of `state` to an equilibrium under some controls. Friction history
  /// stays as it is until `accept`.
  NewtonSummary find_equilibrium(State& state, const Controls& controls = kNoControls);

  /// Ends the step at the equilibrium found: friction and all other history go on from there.
  /// @return the work done against friction (J)
  double accept(State& state) const;

 private:
  const System& system_;
  NewtonOptions options_;
  Workspace workspace_;
};

}  // namespace pliant
