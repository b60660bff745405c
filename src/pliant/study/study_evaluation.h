#pragma once

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/material/material.h"
#include "pliant/study/found_nuisance.h"
#include "pliant/study/study.h"

namespace pliant {

/// Predicts a study's experiments with a given material; nothing is fitted. Those that need a
/// component which the material does not have are skipped; a material that states another fabric
/// or model than the study is questioned.
/// @param found  beside the material by its fit: taken where experiments have numbers of these
/// names
/// @throws InputError when no experiment is left
StudyResult evaluate_study(const Study& study, const Material& material, const RunContext& context,
                           const FoundNuisance& found = {});

}  // namespace pliant
