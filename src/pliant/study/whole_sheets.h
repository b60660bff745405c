#pragma once

#include <memory>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/experiment/whole_sheet_test.h"
#include "pliant/study/study.h"

namespace pliant {

/// Whether no fit learns from an experiment: it is predicted with a whole material.
bool is_only_predicted(const ExperimentSpec& spec);

/// Such an experiment, its data read.
/// @throws InputError for unusable data
std::unique_ptr<WholeSheetTest> read_whole_sheet_test(const ExperimentSpec& spec);

/// Adds the predictions of such experiments of a study with a material to a result. Where the
/// material lacks a component they are skipped.
/// @throws InputError for a material that no sheet can be made of
void evaluate_whole_sheets(const Study& study, const Material& material, const RunContext& context,
                           StudyResult& result);

/// Warns that a fit leaves such experiments out.
void warn_of_whole_sheets(const Study& study, StudyResult& result);

}  // namespace pliant
