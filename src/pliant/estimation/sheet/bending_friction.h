#pragma once

#include "pliant/estimation/sheet/sheet_fitting.h"

namespace pliant {

/// Friction of all directions of a stage that bend, from sheets over a table's edge: kept where it
/// is worth its numbers (`is_worth`) or the study insists on it.
/// @throws SolverError where the sheets have no path with any
void fit_bending_friction(SheetFitting& fitting, const SheetStage& stage);

}  // namespace pliant
