#pragma once

#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/solver/static_path.h"

namespace pliant {

/// The shape of a sheet that a path has come to.
/// @param point  its last equilibrium; the derivatives of the positions are taken out of it
SheetShape path_shape(const SheetSystem& sheet, const State& state, PathEquilibrium& point);

/// What a step of a path has cost.
/// @param seconds         of the whole step
/// @param differentiated  whether derivatives were asked for
EquilibriumWork path_work(const PathEquilibrium& point, double seconds, bool differentiated);

}  // namespace pliant
