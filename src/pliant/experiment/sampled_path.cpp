#include "pliant/experiment/sampled_path.h"

#include <cmath>

namespace pliant {

SampledPath sample_path(const std::vector<double>& turns, double spacing) {
  SampledPath path;
  double next = 0;  // distance along the path of the next sample
  double travelled = 0;
  for (size_t leg = 0; leg + 1 < turns.size(); ++leg) {
    const double from = turns[leg], to = turns[leg + 1];
    const double distance = std::abs(to - from);
    HalfCycle half;
    half.first = static_cast<int>(path.value.size());
    half.direction = to > from ? 1 : -1;
    half.turn = to;
    const bool last_leg = leg + 2 == turns.size();
    while (next < travelled + distance || (last_leg && next <= travelled + distance)) {
      path.value.push_back(from + half.direction * (next - travelled));
      path.cycle.push_back(static_cast<int>(leg / 2) + 1);
      next += spacing;
    }
    travelled += distance;
    half.last = static_cast<int>(path.value.size()) - 1;
    if (half.last >= half.first) path.half_cycles.push_back(half);
  }
  return path;
}

void set_duration(double duration, SampledPath& path) {
  const auto last = static_cast<double>(path.value.size()) - 1;
  path.time.clear();
  for (std::size_t row = 0; row < path.value.size(); ++row) {
    path.time.push_back(duration * static_cast<double>(row) / last);
  }
}

std::vector<double> cycle_turns(double start, const std::vector<double>& peaks, int repeats) {
  std::vector<double> turns{start};
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (const double peak : peaks) turns.insert(turns.end(), {peak, start});
  }
  return turns;
}

}  // namespace pliant
