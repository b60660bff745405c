#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "pliant/estimation/solid/solid_problem.h"
#include "pliant/estimation/statistics/model_growth.h"

namespace pliant {

/// One step of growing a solid.
struct SolidGrowthStage {
  int size = 0;    ///< control points of all components together, or samples
  double rms = 0;  ///< of the weighted differences
  bool accepted = false;
  std::optional<GrowthEnd> end = {};  ///< of the last step: why it went no further
};

struct GrownSolid {
  Material material;
  LeastSquaresSummary solution;
  std::vector<SolidGrowthStage> stages;
};

/// A material with one control point more, fitted; nothing where there is no place for it.
using OneMorePoint =
    std::function<std::optional<Material>(const Material& material, LeastSquaresSummary& solution)>;

/// Grows a fitted material point by point while one or two more are worth it (`is_worth`), to as
/// many as the study allows.
/// @param first  how many points it has
/// @param rich   as many as make sense
GrownSolid grow_points(SolidProblem& problem, const GrownSolid& from, int first,
                       const Material& rich, const OneMorePoint& one_more);

/// Grows the spline energies of a material, each point where the data say that it explains most: at
/// rest, at an end, or at a quantile of the strains of the data. Control values are never negative,
/// so that each energy is convex.
/// @param from  fitted, its spline energies with one control point each
GrownSolid grow_splines(SolidProblem& problem, const GrownSolid& from);

}  // namespace pliant
