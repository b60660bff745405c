#pragma once

#include <optional>
#include <vector>

#include "pliant/experiment/component_experiment.h"

namespace pliant {

/// One way of a loop, out or back; it begins where the one before it ended.
struct LoopBranch {
  std::vector<double> x, y;
  int direction = 0;
  int specimen = 0;

  double reach() const;
  /// Ordinate where it passes a place, the first passage: samples may be noisy.
  std::optional<double> at(double place) const;
};

/// The ways of a loop in their order.
/// @param path  directions and specimens of its rows
std::vector<LoopBranch> branches_of(const LoopSeries& series, const MeasuredPath& path);

}  // namespace pliant
