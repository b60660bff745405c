#pragma once

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/material/material.h"
#include "pliant/study/study.h"

namespace pliant {

/// Predicts a study's experiments with a given material; nothing is fitted.
/// @throws InputError when the material lacks a component that an experiment needs
StudyResult evaluate_study(const Study& study, const Material& material, const RunContext& context);

}  // namespace pliant
