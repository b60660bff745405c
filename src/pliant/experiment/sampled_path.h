#pragma once

#include <vector>

#include "pliant/measurement/turning_points.h"

namespace pliant {

/// A path between turning values at even speed, sampled so that turns fall between samples as they
/// do on a machine.
struct SampledPath {
  std::vector<double> value;
  std::vector<int> cycle;  ///< 1, 2, ...
  std::vector<HalfCycle> half_cycles;
  std::vector<double> time = {};  ///< s; empty: none is told
};

/// @param turns    first value, then each at which the path turns, then the last
/// @param spacing  from sample to sample along the path
SampledPath sample_path(const std::vector<double>& turns, double spacing);

/// Gives the samples the times of a path that takes this long (s).
void set_duration(double duration, SampledPath& path);

/// Turns of cycles from `start` to each peak and back, the whole sequence repeated.
std::vector<double> cycle_turns(double start, const std::vector<double>& peaks, int repeats);

}  // namespace pliant
