#pragma once

#include <filesystem>
#include <string>

#include "pliant/estimation/model_comparison.h"
#include "pliant/study/result_files.h"
#include "pliant/study/sheet_model_fits.h"

namespace pliant {

/// Several cloth models fitted to the same sessions: summary.json, fits-of-models/1.
struct ModelFits {
  std::string name;  ///< of the study
  RunFacts facts;
  ModelComparison comparison;
  std::string verdict;
};

/// Adds what came of one fit, at its place in the tables.
void add_fit(const ModelFit& fit, ModelComparison& comparison);

/// summary.csv: a line for each fit.
std::string summary_csv(const ModelComparison& comparison);

std::string summary_json(const ModelFits& fits);

/// Reads `directory`/summary.json. One of an earlier version, without a verdict, is judged here.
/// @throws InputError where it is missing, broken, or a field is not what it must be
ModelFits read_model_fits(const std::filesystem::path& directory);

}  // namespace pliant
