#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/fit_result.h"
#include "pliant/experiment/session/sheet_test.h"
#include "pliant/study/study.h"

namespace pliant {

/// An experiment of a study that is predicted as a sheet.
struct SheetExperiment {
  SheetTest test;
  ExperimentRole role = ExperimentRole::fit;
  std::string type, direction;       ///< as results name them
  std::vector<std::string> handled;  ///< what was found in the data and how it was dealt with
};

/// The sessions of a study and strips that its model takes as sheets, on the meshes that they are
/// simulated on.
/// @param result  gets what there is to say of them
/// @throws InputError for sessions that cannot be used
std::vector<SheetExperiment> read_sheet_experiments(const Study& study, StudyResult& result);

}  // namespace pliant
