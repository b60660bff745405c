#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "pliant/report/figure.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/prediction.h"
#include "pliant/study/results.h"

namespace pliant::report {

struct LoopFigure {
  Figure figure;
  std::vector<SeriesStyle> legend;
  std::size_t drawn = 0, total = 0;  ///< measured rows
};

struct LoopFigureOptions {
  std::size_t budget = 800;                      ///< rows to draw
  bool compact = false;                          ///< page one: only the loops, small
  std::optional<MembraneMeasure> membrane = {};  ///< of the strains, as far as it is known
};

/// Measured and predicted load-unload loops of one experiment: force against extension, or load
/// against length where lengths are measured.
LoopFigure loop_figure(const ResultExperiment& experiment, const Prediction& prediction,
                       const LoopFigureOptions& options);

}  // namespace pliant::report
