#pragma once

#include <string>

#include "pliant/estimation/fit_result.h"

namespace pliant {

/// measures/EXPERIMENT.csv: what the thesis plots of a session ([T] Figs. 3.5 and 3.6), frame by
/// frame, measured and predicted (docs/formats/results.md). A cell is empty where the session has
/// no such quantity.
std::string frame_measure_table(const SheetComparison& sheet);

}  // namespace pliant
