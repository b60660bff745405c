#pragma once

#include "pliant/base/progress.h"
#include "pliant/solver/objective.h"

namespace pliant {

struct RelaxationOptions {
  double tolerance = 1e-5;  ///< largest force left on a free point (N; [T] 3.4.1: 10 uN)
  int max_iterations = 1000000;
};

struct RelaxationSummary {
  bool converged = false;
  int iterations = 0;    ///< pseudo time steps, each with one evaluation of the forces
  int peaks = 0;         ///< of kinetic energy, at which all motion was stopped
  int mass_updates = 0;  ///< assemblies of the stiffness
  double residual = 0;   ///< largest force left (N)
  Energy energy;
};

/// Minimises an objective by dynamic relaxation with kinetic damping ([T] 4.3.2; Barnes 1999;
/// Volino and Magnenat-Thalmann 2007): undamped motion of fictitious masses, all of it stopped at
/// every peak of its kinetic energy.
///
/// It needs forces, and the stiffness only now and then, for the masses: a quarter of the row sums
/// of the stiffness is what a pseudo time step of 1 needs to be stable. Where the energy rises
/// above that at rest, they were too small for a stiffness met on the way; the motion then begins
/// again with larger ones. Not converging is a result, not an error; what was reached is then in
/// `at`.
/// @param hessian  of the system, room to assemble the stiffness
/// @param at       where to begin, then the minimum
/// @param stop     asked in every pseudo time step
/// @throws Interrupted when asked to stop; `at` then is what was reached
RelaxationSummary relax(const Objective& objective, const RelaxationOptions& options,
                        Hessian& hessian, Configuration& at, const StopToken& stop = {});

}  // namespace pliant
