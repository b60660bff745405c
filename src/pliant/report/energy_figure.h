#pragma once

#include <vector>

#include "pliant/report/figure.h"
#include "pliant/report/plot_style.h"
#include "pliant/scene/simulation_result.h"

namespace pliant::report {

/// One kind of energy, a number a frame.
struct EnergySeries {
  SeriesStyle style;
  std::vector<double> values;  ///< J
};

struct EnergyFigure {
  Figure figure;
  std::vector<SeriesStyle> legend;
  std::vector<EnergySeries> series;  ///< what is drawn, of all frames
};

/// The energies of a simulation over time, and beside them what was lost. Stored and total energy
/// are drawn less what they are at the first frame: where the zero of gravity's lies means nothing.
EnergyFigure energy_figure(const SimulationResult& simulation, const std::vector<EnergyRow>& rows);

}  // namespace pliant::report
