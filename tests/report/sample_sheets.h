#pragma once

#include <filesystem>

#include "pliant/measurement/session.h"
#include "pliant/report/sheet_session.h"

namespace pliant::testing {

/// A square sheet of 9 x 9 nodes and 0.1 m, in the world as at rest.
inline constexpr int kSheetNodes = 9;
inline constexpr double kSheetSide = 0.1;

/// Bars at the sides along weft that move apart, evenly from frame to frame up to `extension` (m)
/// in the last; the sheet between them is stretched evenly and pulls with `stiffness` (N/m).
Session stretched_sheet(int frames, double extension, double stiffness);

/// A sheet that lies on a table up to 50 mm and falls from there, steeper from frame to frame.
Session hanging_sheet(int frames);

/// The session as it might be predicted: its free nodes are higher by `offset` (m) and its clips
/// pull as much more, each away from the other, as `force` says (N).
report::SheetSession with_residuals(const Session& measured, double offset, double force);

/// A results directory of a fit to, or an evaluation on, a stretch, whose forces are 0.02 N too
/// large, and a bend, whose free nodes are 2 mm too high.
void write_sample_sheets(const std::filesystem::path& directory, bool evaluation = false);

}  // namespace pliant::testing
