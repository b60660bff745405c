#pragma once

#include "pliant/experiment/session/virtual_session.h"

namespace pliant {

/// Adds the frames of a sheet that is pushed over the edge of a table, a little further from frame
/// to frame. Each is an equilibrium of the elastic sheet.
/// @param session  with its rest mesh, sample and gravity
/// @throws SolverError
void push_over_edge(const Material& material, const VirtualSession& options,
                    const SessionWork& work, Session& session);

}  // namespace pliant
