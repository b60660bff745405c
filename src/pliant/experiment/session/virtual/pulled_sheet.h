#pragma once

#include "pliant/experiment/session/virtual/cut_sheet.h"
#include "pliant/experiment/session/virtual_session.h"

namespace pliant {

/// Adds the frames of a sheet between clips: the clips' poses are prescribed, and their cords pull
/// with what holds them there.
/// @param session  with its rest mesh, sample and gravity
/// @throws SolverError
void pull_sheet(const CutSheet& sheet, const Material& material, const VirtualSession& options,
                const SessionWork& work, Session& session);

}  // namespace pliant
