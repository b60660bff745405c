#pragma once

#include <optional>
#include <vector>

#include "pliant/experiment/component_experiment.h"

namespace pliant {

/// What a textile lab reads off the largest load-unload cycle of a loop.
struct LoopMetrics {
  double secant_modulus = 0;  ///< force per width and engineering strain at the peak (N/m)
  double hysteresis_ratio =
      0;  ///< (Fload - Funload) / their mean at half of the cycle's extension ([T] 5.2.2)
  double loop_loss = 0;  ///< work lost in the cycle per work done in loading it
};

/// Metrics of the cycle with the largest extension that has both a loading and an unloading branch.
/// @param series    the loop of one quantity, measured or predicted
/// @param path      directions and specimens of its rows
/// @return nothing when the path never unloads by at least a tenth of its extension
std::optional<LoopMetrics> loop_metrics(const LoopSeries& series, const MeasuredPath& path);

/// Whether the experiment unloads by enough to show friction: some unloading branch of at least a
/// tenth of the path's range.
bool unloads(const MeasuredPath& path);

/// Whether any of them does.
bool any_unloads(const std::vector<const ComponentExperiment*>& experiments);

}  // namespace pliant
