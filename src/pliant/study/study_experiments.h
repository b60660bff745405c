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

/// Adds the warnings and questions of an experiment's data to the result of its study.
template <class Data>
void add_remarks(const std::string& experiment, const Data& data, StudyResult& result) {
  for (const std::string& text : data.warnings) {
    result.warnings.push_back(experiment + ": " + text);
  }
  for (const std::string& text : data.questions) {
    result.questions.push_back(experiment + ": " + text);
  }
}

/// Warns of what the study's fit says of parameters that the result does not have.
void warn_of_unmatched_options(const FitOptions& options, StudyResult& result);

/// What fitting or predicting these experiments assumes, in sentences for the report.
std::vector<std::string> assumptions_of(const Study& study, const Experiments& experiments);

}  // namespace pliant
