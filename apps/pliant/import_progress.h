#pragma once

#include <functional>

#include "pliant/base/run_context.h"
#include "pliant/io/result_directory.h"
#include "pliant/study/imported_study.h"

#include "apps/pliant/command.h"

namespace pliant {

/// An import of pictures that keeps what it found in them in a file in the folder of its results,
/// frame by frame, until they are complete: one that was stopped, or refused for something that can
/// be mended, goes on from there.
/// @param resume  whether to go on from what stands there
/// @throws InputError where nothing does, and as `work`
ImportedStudy remembering(ResultDirectory& results, bool resume, const CommandContext& context,
                          const std::function<ImportedStudy(const RunContext&)>& work);

}  // namespace pliant
