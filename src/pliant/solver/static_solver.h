#pragma once

#include "pliant/math/sparse_cholesky.h"
#include "pliant/solver/newton.h"

namespace pliant {

/// Equilibria of a system by Newton's method on a sparse Cholesky factor whose symbolic analysis is
/// done once ([T] 3.4.1).
class StaticSolver {
 public:
  explicit StaticSolver(const System& system,
                        const NewtonOptions& options = {.reuse_factor = true});

  /// Moves the configuration of `state` to an equilibrium, under what its drives say at
  /// `state.time`. Friction history stays as it is until `accept`.
  NewtonSummary find_equilibrium(State& state);

  /// Ends the step at the equilibrium found: friction and all other history go on from there.
  /// @return the work done against friction (J)
  double accept(State& state) const;

 private:
  const System& system_;
  NewtonOptions options_;
  Hessian hessian_;
  SparseCholesky solver_;
};

}  // namespace pliant
