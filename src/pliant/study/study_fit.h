#pragma once

#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/study/study.h"

namespace pliant {

/// What a fit does beyond fitting.
struct StudyFitOptions {
  bool compare_friction = false;  ///< rank the parameterisations of [T] Fig. 5.3
  std::vector<std::string>
      profiles;  ///< parameters (names or patterns) whose profile likelihood is wanted
};

/// Fits a material to a study: each component from its own experiments, then every experiment
/// predicted, the validation ones without any fitting.
/// @throws InputError for unusable data, or a study without an experiment that can be fitted;
/// Interrupted
StudyResult fit_study(const Study& study, const StudyFitOptions& options,
                      const RunContext& context);

}  // namespace pliant
