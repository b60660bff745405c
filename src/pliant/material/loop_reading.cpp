#include "pliant/material/loop_reading.h"

namespace pliant {

double mean_slope(const LoopWays& loop, double from, double to) {
  const auto of_side = [&](double side) {
    const auto rise = [&](double at) { return loop.up(side * at) + loop.down(side * at); };
    return side * (rise(to) - rise(from)) / (2 * (to - from));
  };
  return loop.to_both_sides ? (of_side(1) + of_side(-1)) / 2 : of_side(1);
}

double mean_width(const LoopWays& loop, double at) {
  const auto of_side = [&](double side) { return loop.up(side * at) - loop.down(side * at); };
  return loop.to_both_sides ? (of_side(1) + of_side(-1)) / 2 : of_side(1);
}

}  // namespace pliant
