#pragma once

#include "pliant/estimation/sheet/sheet_fitting.h"

namespace pliant {

/// Gives the curve of a group the control points that it is worth over the strains of the fitted
/// sheets, and the addends beside it.
/// @param rms  of the differences so far (N or m)
void grow(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group, double rms);

/// As many control points as the curve is worth, where they are worth most.
/// @return the root mean square of the differences then (N or m)
double refine(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group,
              double rms);

}  // namespace pliant
