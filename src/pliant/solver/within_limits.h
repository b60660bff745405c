#pragma once

#include "pliant/solver/newton.h"

namespace pliant {

/// The equilibrium of a system in which no energy passes its limit ([T] 4.2.5): barriers are
/// followed (limit_barriers.h) until they are so low that the forces of limits are those of the
/// multipliers of the complementarity problem. The system may begin beyond a limit, as where points
/// were led. Without limits it is `minimize`.
/// @param at  where to begin, then what was found
/// @return counts of all searches; not converged where nothing within the limits was found
NewtonSummary minimize_within_limits(const System& system, const Conditions& under,
                                     const NewtonOptions& options, Workspace& workspace,
                                     Configuration& at);

}  // namespace pliant
