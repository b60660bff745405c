#pragma once

#include <filesystem>
#include <string>

namespace pliant {

/// The report on `pliant fit --models --variants`: several cloth models fitted to the same sessions
/// ([T] Tables A.1-A.4), one self-contained HTML file, with links to the report of each fit.
/// @param results_directory  holds summary.json
/// @throws InputError where it is missing or not what its format says
std::string make_model_fits_report(const std::filesystem::path& results_directory);

}  // namespace pliant
