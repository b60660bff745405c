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
  EquilibriumWork work;
};

/// @throws SolverError where the fitted material predicts nothing
SheetUncertainty sheet_uncertainty(const SheetFit& fit, const FitOptions& options,
                                   const RunContext& context);

}  // namespace pliant
