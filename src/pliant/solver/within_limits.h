#pragma once

#include "pliant/solver/newton.h"

namespace pliant {

/// The equilibrium of a system in which no energy passes its limit ([T] 4.2.5): barriers are
/// followed until they are so low that the forces of limits are those of the multipliers of the
/// complementarity problem. Where the system begins beyond a limit, as where points were led, it is
/// brought back first. Without limits it is `minimize`.
/// @param at  where to begin, then what was found
/// @return counts of all searches; not converged where nothing within the limits was found
NewtonSummary minimize_within_limits(const System& system, const Conditions& under,
                                     const NewtonOptions& options, Workspace& workspace,
                                     Configuration& at, PhaseSeconds* seconds = nullptr);

}  // namespace pliant
