#include "pliant/capture/force_log.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/capture/line_through_rows.h"

namespace pliant {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A column at times between those of its rows, NaN beside them.
std::vector<double> interpolated(const std::vector<double>& at, const std::vector<double>& values,
                                 const std::vector<double>& times) {
  std::vector<double> result;
  for (const double time : times) {
    const bool is_covered = time >= at.front() && time <= at.back();
    result.push_back(is_covered ? line_at(at, values, time).value : kNone);
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

/// Times of frames taken at a rate, all of which the log covers, or half where it is told when
/// they begin.
std::vector<double> frame_times(const DicForces& forces, int frames, double start,
                                const std::vector<double>& log) {
  std::vector<double> times;
  for (int frame = 0; frame < frames; ++frame) times.push_back(start + frame / *forces.rate);
  const auto covered = std::ranges::count_if(
      times, [&](double time) { return time >= log.front() && time <= log.back(); });
  const int fewest = forces.start ? (frames + 1) / 2 : frames;
  if (covered < fewest || log.size() < 2) {
    throw InputError(
        forces.data.where,
        fmt::format("tells times from {:.6g} s to {:.6g} s, and the frames are from {:.6g} s to "
                    "{:.6g} s",
                    log.front(), log.back(), times.front(), times.back()),
        "a log that covers the frames; `start` says when the first was taken by its clock");
  }
  return times;
}

}  // namespace

FrameLog read_log_rows(const DicForces& forces) {
  const DataRows rows(forces.data);
  FrameLog log;
  log.force = rows.quantity("force", Dimension::force);
  if (auto extension = rows.optional_quantity("extension", Dimension::length)) {
    log.extension = *std::move(extension);
  }
  if (auto time = rows.optional_quantity("time", Dimension::time)) log.time = *std::move(time);
  if (!log.time.empty()) require_increasing_times(log.time, rows);
  if (forces.rate && log.time.empty()) {
    rows.quantity("time", Dimension::time);  // says what is missing
  }
  return log;
}

FrameLog log_of_frames(FrameLog rows, const DicForces& forces, int frames, double start) {
  if (forces.rate) {
    const std::vector<double> times = frame_times(forces, frames, start, rows.time);
    rows.force = interpolated(rows.time, rows.force, times);
    if (!rows.extension.empty()) rows.extension = interpolated(rows.time, rows.extension, times);
    rows.time = times;
  } else if (std::ssize(rows.force) != frames) {
    throw InputError(forces.data.where,
                     fmt::format("has {} rows, and there are {} frames", rows.force.size(), frames),
                     "a row a frame; or a column of times, and the `rate` of the frames");
  }
  return rows;
}

}  // namespace pliant
