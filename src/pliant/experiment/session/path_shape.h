#pragma once

#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/solver/static_path.h"

namespace pliant {

/// The shape of a sheet that a path has come to.
/// @param positions  of the nodes at its last equilibrium
/// @param point      that equilibrium; the derivatives of the positions are taken out of it
SheetShape path_shape(const SheetSystem& sheet, Eigen::Matrix3Xd positions, PathEquilibrium& point);

/// What a step of a path has cost.
/// @param differentiated  whether derivatives were asked for
EquilibriumWork path_work(const PathEquilibrium& point, bool differentiated);

}  // namespace pliant
