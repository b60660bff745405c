#include "pliant/capture/still_reading.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "pliant/base/quantity.h"

namespace pliant {

std::optional<StillReading> still_reading(const std::vector<double>& times,
                                          const std::vector<double>& values, double middle,
                                          double still, double largest) {
  constexpr double kErrors = 4, kShare = 0.01;  // of the largest reading
  if (times.empty() || middle < times.front() || middle > times.back()) return std::nullopt;
  const double from = middle - still / 2, to = middle + still / 2;
  const auto first = std::ranges::lower_bound(times, from) - times.begin();
  const auto last = std::ranges::upper_bound(times, to) - times.begin();
  const auto count = static_cast<double>(last - first);
  if (count < 3) return std::nullopt;
  StillReading reading;
  double time = 0;
  for (auto row = static_cast<std::size_t>(first); row < static_cast<std::size_t>(last); ++row) {
    reading.mean += values[row] / count;
    time += times[row] / count;
  }
  double along = 0, both = 0, squares = 0;
  for (auto row = static_cast<std::size_t>(first); row < static_cast<std::size_t>(last); ++row) {
    along += (times[row] - time) * (times[row] - time);
    both += (times[row] - time) * (values[row] - reading.mean);
    squares += (values[row] - reading.mean) * (values[row] - reading.mean);
  }
  const double slope = both / along;
  const double way =
      times[static_cast<std::size_t>(last) - 1] - times[static_cast<std::size_t>(first)];
  reading.spread = std::sqrt(std::max(squares - slope * both, 0.0) / (count - 2));
  reading.error = reading.spread / std::sqrt(count);
  reading.creep = slope * way;
  const double error_of_creep = reading.spread / std::sqrt(along) * way;
  reading.creeps = std::abs(reading.creep) > std::max(kErrors * error_of_creep, kShare * largest);
  return reading;
}

FrameStand frame_stand(const StillReading& reading, const std::string& name) {
  FrameStand stand{reading.spread, {}};
  if (reading.creeps) {
    stand.creep = fmt::format("{} creeps by {} while the sample stands still, from {}", name,
                              format_quantity(reading.creep, Dimension::force, 2),
                              format_quantity(reading.mean, Dimension::force, 3));
  }
  return stand;
}

}  // namespace pliant
