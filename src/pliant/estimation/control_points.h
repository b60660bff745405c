#pragma once

#include <vector>

#include "pliant/estimation/component_problem.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// The strains of a component's rows that count.
struct DataStrains {
  std::vector<double>
      sorted;      ///< without negative ones, which are slack; of even curves their size
  double low = 0;  ///< between which control points stand
  double high = 0;
};

DataStrains data_strains(const ComponentProblem& problem, bool even);

/// A law with a Hermite stiffness on some knots, for the rest of the form of another.
ComponentLaw on_knots(ComponentLaw form, const std::vector<double>& knots, bool even);

/// The knots of a law's stiffness with one more.
///
/// The thesis places control points at equal distances. Here each new one splits the interval whose
/// splitting explains most of the data, in its middle, at the median of the data's strains or where
/// half of its rise in stress is reached, whichever is best: a stiff weave with a long toe needs
/// its points where the curve bends.
/// @return the same knots where no interval is wide enough
std::vector<double> split_knots(const ComponentProblem& problem, const ComponentLaw& law,
                                const DataStrains& strains);

/// The same law with its curve on more knots.
ComponentLaw refined(const ComponentLaw& law, const std::vector<double>& knots);

}  // namespace pliant
