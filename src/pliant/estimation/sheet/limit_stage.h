#pragma once

#include "pliant/estimation/sheet/sheet_fitting.h"

namespace pliant {

/// Limits of energies ([T] 4.2.5), each fitted together with the curves of a stage; what fits best
/// is kept.
/// @throws SolverError where no limit lets the sheets be predicted
void fit_limits(SheetFitting& fitting, const SheetStage& stage);

}  // namespace pliant
