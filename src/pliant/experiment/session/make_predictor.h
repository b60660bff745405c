#pragma once

#include <memory>

#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/material/material.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// Whether each frame of a session follows from those before: where friction of its sheet shows. On
/// a table a sheet bends, and hardly stretches: friction of bending alone shows there.
bool is_path(const Session& session, const Material& material);

/// Predicts a session as a path, or frame by frame.
/// @param session   on the mesh that is simulated; outlives the predictor
/// @param material  complete
std::unique_ptr<SheetPredictor> make_predictor(const Session& session, const Material& material);

}  // namespace pliant
