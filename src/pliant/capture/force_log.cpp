#include "pliant/capture/force_log.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
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
std::vector<double> frame_times(const DicForces& forces, const std::vector<int>& moments,
                                double start, const std::vector<double>& log) {
  std::vector<double> times;
  for (const int moment : moments) times.push_back(start + moment / *forces.rate);
  const auto covered = std::ranges::count_if(
      times, [&](double time) { return time >= log.front() && time <= log.back(); });
  const std::ptrdiff_t frames = std::ssize(times);
  const std::ptrdiff_t fewest = forces.start ? (frames + 1) / 2 : frames;
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

/// What one column of a log says at each frame: between its rows, or where the file tells how long
/// frames stand still the mean of the rows in that time. NaN where a row of those is.
struct ColumnAtFrames {
  std::vector<double> values;
  std::vector<std::optional<StillReading>> readings;  // empty where that is not told
};

ColumnAtFrames column_at_frames(const DicForces& forces, const std::vector<double>& log,
                                const std::vector<double>& column,
                                const std::vector<double>& times) {
  if (!forces.still) return {interpolated(log, column, times), {}};
  double largest = 0;
  for (const double value : column) largest = std::max(largest, std::abs(value));
  ColumnAtFrames result;
  for (const double time : times) {
    auto reading = still_reading(log, column, time, *forces.still, largest);
    const bool has_rows = reading.has_value();
    result.values.push_back(has_rows ? reading->mean : kNone);
    if (std::isnan(result.values.back())) reading.reset();
    result.readings.push_back(reading);
    const bool is_covered = time >= log.front() && time <= log.back();
    if (!is_covered || has_rows) continue;
    throw InputError(forces.data.where,
                     fmt::format("has less than three rows within {} of {:.6g} s, while frame {} "
                                 "stands still",
                                 format_quantity(*forces.still / 2, Dimension::time, 3), time,
                                 result.values.size() - 1),
                     "a log of more rows, or a longer `still`");
  }
  return result;
}

void require_row_a_frame(const DicForces& forces, std::size_t rows, std::size_t frames) {
  if (rows == frames) return;
  throw InputError(forces.data.where,
                   fmt::format("has {} rows, and there are {} frames", rows, frames),
                   "a row a frame; or a column of times, and the `rate` of the frames");
}

/// The times of a log's rows.
std::vector<double> read_times(const DataRows& rows, const DicForces& forces) {
  auto time = rows.optional_quantity("time", Dimension::time);
  if (time) require_increasing_times(*time, rows);
  if (forces.rate && !time) rows.quantity("time", Dimension::time);  // says what is missing
  return time ? *std::move(time) : std::vector<double>();
}

}  // namespace

FrameLog read_log_rows(const DicForces& forces) {
  const DataRows rows(forces.data);
  FrameLog log;
  log.force = rows.quantity("force", Dimension::force);
  if (auto extension = rows.optional_quantity("extension", Dimension::length)) {
    log.extension = *std::move(extension);
  }
  log.time = read_times(rows, forces);
  return log;
}

FrameLog log_of_frames(FrameLog rows, const DicForces& forces, const std::vector<int>& moments,
                       double start) {
  if (!forces.rate) {
    require_row_a_frame(forces, rows.force.size(), moments.size());
    return rows;
  }
  const std::vector<double> times = frame_times(forces, moments, start, rows.time);
  ColumnAtFrames force = column_at_frames(forces, rows.time, rows.force, times);
  for (const auto& reading : force.readings) {
    rows.stands.emplace_back();
    if (reading) rows.stands.back() = frame_stand(*reading, "the force");
  }
  rows.force = std::move(force.values);
  if (!rows.extension.empty()) rows.extension = interpolated(rows.time, rows.extension, times);
  rows.time = times;
  return rows;
}

std::vector<double> CellRows::total() const {
  std::vector<double> total(pull.front().size(), 0);
  for (const std::vector<double>& cell : pull) {
    std::ranges::transform(total, cell, total.begin(), std::plus());
  }
  return total;
}

CellRows read_cell_rows(const DicForces& forces) {
  const DataRows rows(forces.data);
  CellRows cells{read_times(rows, forces), {}};
  for (const DicCell& cell : forces.cells) {
    std::vector<double> pull = rows.quantity(cell.column, Dimension::force);
    for (double& force : pull) force = cell.slope * (force - cell.tare);
    cells.pull.push_back(std::move(pull));
  }
  return cells;
}

CellLog cells_at_frames(const CellRows& rows, const DicForces& forces,
                        const std::vector<int>& moments, double start) {
  CellLog log;
  if (!forces.rate) {
    require_row_a_frame(forces, rows.pull.front().size(), moments.size());
    log.time = rows.time;
    log.pull = rows.pull;
    return log;
  }
  log.time = frame_times(forces, moments, start, rows.time);
  double squares = 0;
  int readings = 0;
  for (std::size_t i = 0; i < rows.pull.size(); ++i) {
    const DicCell& cell = forces.cells[i];
    ColumnAtFrames at = column_at_frames(forces, rows.time, rows.pull[i], log.time);
    log.stands.resize(at.readings.size());
    for (std::size_t f = 0; f < at.readings.size(); ++f) {
      if (!at.readings[f]) continue;
      squares += at.readings[f]->error * at.readings[f]->error;
      ++readings;
      const FrameStand stand = frame_stand(
          *at.readings[f], fmt::format("the cord {} of the clip {}", cell.cord, cell.clip));
      std::optional<FrameStand>& worst = log.stands[f];
      if (!worst) worst.emplace();
      worst->spread = std::max(worst->spread, stand.spread);
      if (worst->creep.empty()) worst->creep = stand.creep;
    }
    log.pull.push_back(std::move(at.values));
  }
  if (readings > 0) log.error = std::sqrt(squares / readings);
  return log;
}

}  // namespace pliant
