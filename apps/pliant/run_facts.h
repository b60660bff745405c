#pragma once

#include <filesystem>

#include "pliant/study/result_files.h"

#include "apps/pliant/command.h"

namespace pliant {

/// What the results of a command say about how they were made: command line, time, version, study
/// and its digest.
RunFacts run_facts(const CommandContext& context, const std::filesystem::path& study);

}  // namespace pliant
