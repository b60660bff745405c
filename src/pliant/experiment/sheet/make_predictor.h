#pragma once

#include <memory>

#include "pliant/experiment/session.h"
#include "pliant/experiment/sheet/sheet_predictor.h"
#include "pliant/material/material.h"

namespace pliant {

/// How a session is predicted: as a path where friction of its sheet shows, else frame by frame.
/// On a table a sheet bends, and hardly stretches: friction of bending alone shows there.
/// @param session   on the mesh that is simulated; outlives the predictor
/// @param material  complete
std::unique_ptr<SheetPredictor> make_predictor(const Session& session, const Material& material);

}  // namespace pliant
