#pragma once

#include <span>
#include <vector>

namespace pliant {

/// A run of samples along which the path moves one way.
struct HalfCycle {
  int first = 0;      ///< first sample; a half cycle begins where the one before ends
  int last = 0;       ///< last sample before the path turned
  int direction = 1;  ///< 1: rising, -1: falling
  double turn =
      0;  ///< value at which the path turned; beyond the last sample if it turned between two
};

/// Index of the extreme sample that ends each half cycle of a path; the last one ends the
/// path. A reversal smaller than `threshold` is noise and does not count.
std::vector<int> turning_samples(std::span<const double> path, double threshold);

/// Splits a sampled path into half cycles.
///
/// A reversal smaller than `threshold` is noise and does not count. The first half cycle begins at
/// sample 0, each other at the sample after the last one before its turning point.
///
/// Where samples are dense the path turned between two of them: between the extreme sample e and
/// its nearer neighbour n. For an even speed v a sample apart the turning value is (x[e] + x[n] +
/// v) / 2 on a rise, never less than the extreme sample.
/// @param path  at least one value
std::vector<HalfCycle> half_cycles_of(std::span<const double> path, double threshold);

/// A threshold for `half_cycles_of`: 0.2 % of the path's range, or four standard deviations of
/// the stated noise of the path where that is more.
double reversal_threshold(std::span<const double> path, double noise);

}  // namespace pliant
