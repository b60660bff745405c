#pragma once

#include <filesystem>
#include <string>

namespace pliant {

/// The report on the results of `pliant fit` or `pliant evaluate`: one self-contained HTML file.
///
/// Text and tables are plain HTML; the figures are data that the embedded drawing script turns
/// into plots. The file loads nothing, from the network or from beside it.
/// @param results_directory  holds fit.json or evaluation.json, curves.csv and predictions/
/// @throws InputError where a results file is missing or not what its format says
std::string make_report(const std::filesystem::path& results_directory);

}  // namespace pliant
