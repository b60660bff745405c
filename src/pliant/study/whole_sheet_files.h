#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "pliant/estimation/whole_sheet_result.h"

namespace pliant {

/// `whole_sheets` of evaluation.json.
nlohmann::ordered_json whole_sheets_json(const std::vector<WholeSheetResult>& results);

/// Adds the tables and pictures of predictions, with their names in a folder of results.
void add_files(const std::vector<WholeSheetResult>& results,
               std::vector<std::pair<std::string, std::string>>& files);

}  // namespace pliant
