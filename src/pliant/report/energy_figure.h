#pragma once

#include <vector>

#include "pliant/report/figure.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/simulation_results.h"

namespace pliant::report {

struct EnergyFigure {
  Figure figure;
  std::vector<SeriesStyle> legend;
};

/// The energies of a simulation over time. Stored and total energy are drawn less what they are at
/// the first frame: where the zero of gravity's lies means nothing.
EnergyFigure energy_figure(const SimulationResults& results);

}  // namespace pliant::report
