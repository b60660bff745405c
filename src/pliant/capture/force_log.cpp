#include "pliant/capture/force_log.h"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

/// A column at times between those of its rows.
std::vector<double> interpolated(const std::vector<double>& at, const std::vector<double>& values,
                                 const std::vector<double>& times) {
  std::vector<double> result;
  for (const double time : times) {
    const auto after = std::ranges::upper_bound(at, time);
    const auto row = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(after - at.begin(), 1, std::ssize(at) - 1));
    const double share = (time - at[row - 1]) / (at[row] - at[row - 1]);
    result.push_back(values[row - 1] + share * (values[row] - values[row - 1]));
  }
  return result;
}

void require_increasing_times(const std::vector<double>& times, const DataRows& rows) {
  for (std::size_t row = 1; row < times.size(); ++row) {
    if (times[row] > times[row - 1]) continue;
    throw InputError(rows.location(static_cast<int>(row), "time"),
                     "does not come after the row before", "times that increase");
  }
}

/// Times of frames taken at a rate from the log's time zero, which the log covers.
std::vector<double> frame_times(double rate, int frames, const std::vector<double>& log,
                                const DicForces& forces) {
  std::vector<double> times;
  for (int frame = 0; frame < frames; ++frame) times.push_back(frame / rate);
  const double last = times.back();
  if (log.size() < 2 || log.front() > 0 || log.back() < last) {
    throw InputError(
        forces.data.where,
        fmt::format("tells times from {} s to {} s, and the frames are from 0 s to {} s",
                    log.front(), log.back(), last),
        "a log that covers the frames");
  }
  return times;
}

}  // namespace

FrameLog read_force_log(const DicForces& forces, int frames) {
  const DataRows rows(forces.data);
  FrameLog log;
  log.force = rows.quantity("force", Dimension::force);
  if (auto extension = rows.optional_quantity("extension", Dimension::length)) {
    log.extension = *std::move(extension);
  }
  if (auto time = rows.optional_quantity("time", Dimension::time)) log.time = *std::move(time);
  if (!log.time.empty()) require_increasing_times(log.time, rows);
  if (forces.rate) {
    if (log.time.empty()) rows.quantity("time", Dimension::time);  // says what is missing
    const std::vector<double> times = frame_times(*forces.rate, frames, log.time, forces);
    log.force = interpolated(log.time, log.force, times);
    if (!log.extension.empty()) log.extension = interpolated(log.time, log.extension, times);
    log.time = times;
  } else if (rows.rows() != frames) {
    throw InputError(forces.data.where,
                     fmt::format("has {} rows, and there are {} frames", rows.rows(), frames),
                     "a row a frame; or a column of times, and the `rate` of the frames");
  }
  return log;
}

}  // namespace pliant
