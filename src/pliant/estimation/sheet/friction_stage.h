#pragma once

#include "pliant/estimation/sheet/sheet_fitting.h"

namespace pliant {

/// Friction of a group, where the loops of a stage are not those of its cords. Now that something
/// makes the loops, the curve gets the control points that it is worth.
void fit_friction(SheetFitting& fitting, const SheetStage& stage, const ComponentGroup& group);

}  // namespace pliant
