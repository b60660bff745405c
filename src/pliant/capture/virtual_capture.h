#pragma once

#include <functional>
#include <string>

#include "pliant/base/run_context.h"
#include "pliant/experiment/virtual_test.h"
#include "pliant/measurement/session.h"
#include "pliant/study/virtual_cameras.h"

namespace pliant {

/// @throws InputError for a session that cameras cannot be drawn of: they see sheets between clips,
///         cut along weft and warp, and sheets over the edge of a table
void require_seen(const VirtualTest& test);

/// Takes the content of a file.
using WriteFile = std::function<void(const std::string& name, const std::string& content)>;

/// Draws what a rig sees of a virtual session: pictures of a calibration board, the first lying on
/// the table; the sheet at rest, flat, with its clips beside it; and each frame. A print of band-
/// limited noise is on the cloth, labels on each clip, and cords pull them. Writes with them
/// rig.yaml, board.yaml, the log of the cords' cells and capture.yaml (dic/1), so that what is
/// measured in the pictures stands beside the session, which is the truth, and truth.json, the
/// cameras as they are (calibration/1).
/// @param session  of a test that `require_seen` lets pass
/// @throws Interrupted
void draw_capture(const Session& session, const VirtualCameras& options, const RunContext& context,
                  const WriteFile& write);

}  // namespace pliant
