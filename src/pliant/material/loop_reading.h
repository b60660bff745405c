#pragma once

#include <functional>

namespace pliant {

/// The two ways of a loop, as what answers to what is imposed.
struct LoopWays {
  std::function<double(double)> up, down;
  bool to_both_sides = true;  ///< else it goes to the positive side alone
};

/// Mean slope of both ways between two places, on each side of zero: B and G of the Kawabata
/// system.
double mean_slope(const LoopWays& loop, double from, double to);

/// Width of the loop at a place, the mean of both sides: 2HB and 2HG.
double mean_width(const LoopWays& loop, double at);

}  // namespace pliant
