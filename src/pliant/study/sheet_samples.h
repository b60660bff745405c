#pragma once

#include <vector>

#include "pliant/estimation/sheet/sheet_plan.h"

namespace pliant {

/// @throws InputError for samples of a model of cloth that its fit cannot have: of what remembers
///         or no stage fits, outside the sheet or two at one place, and beside sheets of several
///         sizes; without effect where the model has none
void require_samples_of_sheet(const FitSettings& settings,
                              const std::vector<const SheetTest*>& tests,
                              const std::vector<SheetStage>& plan);

}  // namespace pliant
