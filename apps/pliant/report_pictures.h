#pragma once

#include <filesystem>

#include "pliant/base/run_context.h"
#include "pliant/render/camera.h"
#include "pliant/report/simulation_report.h"

namespace pliant {

/// Draws the pictures for the report on a simulation, or says why it cannot.
/// @param directory  results of simulate
/// @throws InputError for frames that cannot be read; Interrupted
SimulationPictures report_pictures(const std::filesystem::path& directory, ViewDirection view,
                                   const RunContext& run);

}  // namespace pliant
