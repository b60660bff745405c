#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// A figure of the material, as in fit.json. Intervals are null where no error is known, what a
/// standard says of it where it is of none.
nlohmann::ordered_json figure_json(const LabFigure& figure);

/// The figures of standards that an experiment's loop shows, measured and predicted.
nlohmann::ordered_json loop_figures_json(const ExperimentResult& experiment);

/// figures.csv: all of them in the laboratory's units (docs/formats/results.md).
std::string figures_csv(const StudyResult& result);

}  // namespace pliant
