#pragma once

#include <string>
#include <vector>

#include "pliant/io/result_directory.h"
#include "pliant/study/study.h"

#include "apps/pliant/command.h"

namespace pliant {

/// Fits a study of sessions with several cloth models and variants ([T] Tables A.1-A.4): a folder
/// of results for each in `results`, summary.csv, summary.json and a report; and prints the table.
/// @param study_file  that the study was read from
/// @return the text of summary.json
/// @throws InputError for a study without sessions; what `fit_sheet_models` throws
std::string fit_models(const CommandContext& context, const Study& study,
                       const std::filesystem::path& study_file,
                       const std::vector<std::string>& models,
                       const std::vector<std::string>& variants, ResultDirectory& results);

}  // namespace pliant
