#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/estimation/uncertainty.h"

namespace pliant {

/// What the data of an incremental fit says about its unknowns: those of all groups, then the cords
/// of all tests. Each is told by the tests of its last stage.
struct SheetUncertainty {
  std::vector<Unknown> unknowns;
  Eigen::VectorXd values;
  Uncertainty uncertainty;
  Eigen::VectorXd mesh_error;  ///< part of the standard error of each unknown; empty: not known
  EquilibriumWork work;
};

/// With a second mesh the error of the mesh is in it as well: by how much the estimate would move
/// on that, by one step of Gauss and Newton. An error that is proportional to the edge, as that of
/// these meshes is, moves by as much as it is when the edge is doubled.
/// @param coarser  the tests on meshes of twice the edge, by name; none: no second mesh
/// @throws SolverError where the fitted material predicts nothing
SheetUncertainty sheet_uncertainty(const SheetFit& fit, const FitOptions& options,
                                   const RunContext& context,
                                   const std::vector<const SheetTest*>& coarser = {});

}  // namespace pliant
