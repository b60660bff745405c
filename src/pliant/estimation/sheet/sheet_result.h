#pragma once

#include <optional>
#include <vector>

#include "pliant/estimation/fit_result.h"
#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// Predicted shapes of the frames of a session; nothing for those without equilibrium.
using FrameShapes = std::vector<std::optional<SheetShape>>;

/// A session as it was predicted, frames without equilibrium left out: its own clips, poses and
/// masses, with the positions of predicted shapes and one cord a clip, which pulls with the
/// predicted force where that has the predicted moment, but for the part along the force.
Session predicted_session(const Session& measured, const FrameShapes& shapes);

/// How a session compares with its prediction. Rows are what the test compares of forces, clip by
/// clip and axis by axis; of positions the heights of the free nodes along the middle of the sheet,
/// while the error is that of all free nodes. Rows of frames without equilibrium do not count and
/// are predicted by NaN.
/// @param shapes  of one frame at least
ExperimentResult compare_sheet(const SheetTest& test, const FrameShapes& shapes);

}  // namespace pliant
