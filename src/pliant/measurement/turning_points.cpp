#include "pliant/measurement/turning_points.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr double kRangeShare = 0.002;
constexpr int kDenseSamples =
    8;  // samples a half cycle needs on both sides before it counts as dense

struct Turn {
  int last = 0;  // last sample before the path turned
  double value = 0;
};

// At even speed the nearer neighbour of the extreme sample lies across the turn: when that is the
// sample before it, the extreme sample itself came after the turn.
Turn turn_near(std::span<const double> path, int extreme, int direction) {
  const auto at = [&](int k) { return path[static_cast<size_t>(k)]; };
  const double s = direction;
  const bool passed = s * at(extreme - 1) > s * at(extreme + 1);
  const double across = passed ? at(extreme - 1) : at(extreme + 1);
  const double speed = std::abs(at(extreme - 1) - at(extreme - 5)) / 4;
  const double beyond = s * (across - at(extreme) + s * speed) / 2;
  return {passed ? extreme - 1 : extreme, at(extreme) + s * std::clamp(beyond, 0.0, speed / 2)};
}

}  // namespace

std::vector<int> turning_samples(std::span<const double> path, double threshold) {
  std::vector<int> turns;
  const int count = static_cast<int>(path.size());
  int lowest = 0, highest = 0;
  int direction = 0;  // unknown until the path has moved by the threshold
  for (int i = 1; i < count; ++i) {
    const auto at = [&](int k) { return path[static_cast<size_t>(k)]; };
    if (direction >= 0 && at(i) >= at(highest)) highest = i;
    if (direction <= 0 && at(i) <= at(lowest)) lowest = i;
    if (direction >= 0 && at(highest) - at(i) > threshold) {
      if (direction == 1) turns.push_back(highest);  // at first the path has not turned yet
      direction = -1;
      lowest = i;
    } else if (direction <= 0 && at(i) - at(lowest) > threshold) {
      if (direction == -1) turns.push_back(lowest);
      direction = 1;
      highest = i;
    }
  }
  if (turns.empty() || turns.back() != count - 1) turns.push_back(count - 1);
  return turns;
}

std::vector<HalfCycle> half_cycles_of(std::span<const double> path, double threshold) {
  const std::vector<int> extremes = turning_samples(path, threshold);
  std::vector<HalfCycle> half_cycles;
  int first = 0;
  for (size_t i = 0; i < extremes.size(); ++i) {
    const int extreme = extremes[i];
    const double before = path[static_cast<size_t>(std::max(first - 1, 0))];
    const int direction = path[static_cast<size_t>(extreme)] < before ? -1 : 1;
    Turn turn{extreme, path[static_cast<size_t>(extreme)]};
    const bool ends_path = i + 1 == extremes.size();
    const bool dense = !ends_path && extreme - first >= kDenseSamples &&
                       extremes[i + 1] - extreme >= kDenseSamples;
    if (dense) turn = turn_near(path, extreme, direction);
    half_cycles.push_back({first, turn.last, direction, turn.value});
    first = turn.last + 1;
  }
  return half_cycles;
}

double reversal_threshold(std::span<const double> path, double noise) {
  const auto [low, high] = std::minmax_element(path.begin(), path.end());
  return std::max(kRangeShare * (*high - *low), 4 * noise);
}

}  // namespace pliant
