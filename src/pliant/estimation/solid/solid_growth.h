#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/solid/solid_problem.h"

namespace pliant {

/// One step of growing a solid.
struct SolidGrowthStage {
  int size = 0;    ///< control points of all components together, or samples
  double rms = 0;  ///< of the weighted differences
  bool accepted = false;
};

struct GrownSolid {
  Material material;
  LeastSquaresSummary solution;
  std::vector<SolidGrowthStage> stages;
};

/// Grows the spline energies of a material point by point while one or two more are worth it
/// (`is_worth`), each where the data say that it explains most: at rest, at an end, or at a
/// quantile of the strains of the data. Control values are never negative, so that each energy is
/// convex.
/// @param material  fitted, its spline energies with one control point each
GrownSolid grow_solid(SolidProblem& problem, const Material& material,
                      const LeastSquaresSummary& fitted);

}  // namespace pliant
