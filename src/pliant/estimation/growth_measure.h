#pragma once

#include "pliant/estimation/control_points.h"
#include "pliant/estimation/fit_settings.h"

namespace pliant {

/// What the growth of a component's law is judged by.
struct GrowthMeasure {
  double rows = 0;         ///< that are independent
  double unexplained = 0;  ///< mean square of the weighted residuals that no curve explains: the
                           ///< loops of a law without friction
  double least = 0;        ///< mean square that the richest law leaves
};

/// Measures it by laws with as many control points as there may be.
/// @param form  friction and addends that are fitted along
GrowthMeasure measure_of_growth(const ComponentProblem& problem, const DataStrains& strains,
                                const ComponentLaw& form, const FitOptions& options, bool even);

}  // namespace pliant
