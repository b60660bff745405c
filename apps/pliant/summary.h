#pragma once

#include "pliant/estimation/fit_result.h"

#include "apps/pliant/command.h"

namespace pliant {

/// What a user wants to know at once, on the terminal: what was understood, errors per experiment,
/// parameters, warnings.
void say_fit(const CommandContext& context, const StudyResult& result);
void say_experiments(const CommandContext& context, const StudyResult& result);

}  // namespace pliant
