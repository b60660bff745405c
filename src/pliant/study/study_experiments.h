#pragma once

#include <memory>
#include <string>
#include <vector>

#include "pliant/estimation/fit_result.h"
#include "pliant/experiment/component_experiment.h"
#include "pliant/study/study.h"

namespace pliant {

using Experiments = std::vector<std::unique_ptr<ComponentExperiment>>;

/// The beginning of a study's result: what the study says of itself.
StudyResult describe(const Study& study);

/// The experiments of a study that this version uses, their data read; what is left out becomes a
/// warning of the result.
/// @throws InputError
Experiments read_experiments(const Study& study, StudyResult& result);

/// Warns of what the study's fit says of parameters that the result does not have.
void warn_of_unmatched_options(const FitOptions& options, StudyResult& result);

/// What fitting or predicting these experiments assumes, in sentences for the report.
std::vector<std::string> assumptions_of(const Study& study, const Experiments& experiments);

}  // namespace pliant
