#include "pliant/capture/frame_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/capture/log_clock.h"
#include "pliant/measurement/session/cord_forces.h"

namespace pliant {

FrameForces::FrameForces(const DicFile& dic, const std::vector<SessionClip>& clips, int frames)
    : dic_(dic), frames_(frames) {
  if (!dic.forces) return;
  const DicForces& forces = *dic.forces;
  needs_clock_ = forces.needs_clock();
  const double start = forces.start ? forces.start->time.value_or(0) : 0;
  if (!forces.cells.empty()) {
    cell_rows_ = read_cell_rows(forces);
    if (!needs_clock_) place_cells(start);
    lines_.resize(static_cast<std::size_t>(frames));
    return;
  }
  if (!forces.cords) {
    rows_ = read_log_rows(forces);
    if (!needs_clock_) log_ = log_of_frames(rows_, forces, frames, start);
    return;
  }
  const FrameRows rows(*forces.cords, frames);
  FrameTimes times(frames);
  cords_ = read_cord_forces(rows, clips, frames, times).cords;
  for (const auto& time : times.increasing()) {
    if (time) log_.time.push_back(*time);
  }
  if (std::ssize(log_.time) < frames) log_.time.clear();
}

void FrameForces::place_cells(double start) {
  cells_ = cells_at_frames(cell_rows_, *dic_.forces, frames_, start);
  log_.time = cells_.time;
  log_.stands = cells_.stands;
}

void FrameForces::see_cords(int frame, std::vector<std::optional<CordLine>> lines) {
  lines_[static_cast<std::size_t>(frame)] = std::move(lines);
}

std::optional<double> FrameForces::noise() const {
  double squares = 0;
  int count = 0;
  for (std::size_t f = 0; f < lines_.size(); ++f) {
    for (std::size_t i = 0; i < lines_[f].size(); ++i) {
      const double pull = cells_.pull[i][f];
      if (!lines_[f][i] || std::isnan(pull)) continue;
      const double aside = pull * lines_[f][i]->error;
      squares += (cells_.error * cells_.error + 2 * aside * aside) / 3;
      ++count;
    }
  }
  if (count == 0 || cells_.error == 0) return std::nullopt;
  const auto cords = static_cast<double>(cells_.pull.size());
  return std::sqrt(squares / count * cords / static_cast<double>(dic_.clips.size()));
}

bool FrameForces::is_free(int frame) const {
  const auto f = static_cast<std::size_t>(frame);
  if (!lines_.empty()) {
    return std::ranges::none_of(lines_[f], [](const auto& line) { return line.has_value(); });
  }
  return !cords_.empty() &&
         std::ranges::all_of(cords_[f], [](const auto& cords) { return cords.empty(); });
}

std::size_t FrameForces::pulled() const {
  return static_cast<std::size_t>(dic_.pulled_clip() - dic_.clips.begin());
}

// Of all cords at once, along each, since all were seen: what they pull with all together.
std::vector<double> FrameForces::ways_of_cords() const {
  const auto all_seen = [](const auto& lines) {
    return !lines.empty() &&
           std::ranges::all_of(lines, [](const auto& line) { return line.has_value(); });
  };
  const auto first = std::ranges::find_if(lines_, all_seen);
  std::vector<double> ways;
  for (const auto& lines : lines_) {
    ways.push_back(all_seen(lines) ? 0 : std::numeric_limits<double>::quiet_NaN());
    if (std::isnan(ways.back())) continue;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      ways.back() += lines[i]->direction.dot(lines[i]->from - (*first)[i]->from);
    }
  }
  return ways;
}

std::string FrameForces::find_clock(const std::vector<double>& ways) {
  const DicForces& forces = *dic_.forces;
  const char* expected = "`start`, the time of the first frame by the log's clock";
  const bool by_cells = !forces.cells.empty();
  if (!by_cells && rows_.extension.empty()) {
    throw InputError(forces.data.where, "has no column of the extension to find its clock by",
                     expected);
  }
  const double still = forces.still.value_or(0);
  const ClockLog log =
      by_cells ? ClockLog{cell_rows_.time, cell_rows_.total(), /*goes_straight=*/false, still}
               : ClockLog{rows_.time, rows_.extension, /*goes_straight=*/true, still};
  const ClockSearch search =
      pliant::find_clock(log, by_cells ? ways_of_cords() : ways, *forces.rate);
  if (!search.clock) throw InputError(forces.start->where, "is not found: " + search.why, expected);
  needs_clock_ = false;
  if (by_cells) {
    place_cells(search.clock->start);
  } else {
    log_ = log_of_frames(rows_, forces, frames_, search.clock->start);
  }
  return fmt::format(
      "by {} the first frame was taken at {:.4g} s of the log, to {:.2g} s (they go together by "
      "{:.5f})",
      by_cells ? "the ways of the cords" : "the clip " + forces.clip, search.clock->start,
      search.clock->error, search.clock->correlation);
}

std::string FrameForces::add_to(SessionFrame& frame, int number,
                                const std::vector<HeldPlace>& held) const {
  const auto f = static_cast<std::size_t>(number);
  if (!log_.time.empty()) frame.time = log_.time[f];
  frame.cords.resize(dic_.clips.size());
  if (!dic_.forces) return {};
  if (!cords_.empty()) {
    frame.cords = cords_[f];
    return {};
  }
  return lines_.empty() ? add_tester(frame, f, held) : add_cells(frame, f);
}

double FrameForces::largest_pull(std::size_t cell) const {
  double most = 0;
  for (const double pull : cells_.pull[cell]) {
    if (!std::isnan(pull)) most = std::max(most, std::abs(pull));
  }
  return most;
}

std::string FrameForces::add_cells(SessionFrame& frame, std::size_t number) const {
  const std::vector<std::optional<CordLine>>& lines = lines_[number];
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const DicCell& cell = dic_.forces->cells[i];
    const double pull = cells_.pull[i][number];
    if (!lines[i]) {
      constexpr double kHardly = 0.05;  // of the largest pull
      if (!(std::abs(pull) > kHardly * largest_pull(i))) continue;
      return fmt::format("is pulled by the cord {} of the clip {}, which is pointed at later",
                         cell.cord, cell.clip);
    }
    if (std::isnan(pull)) return kBeyondLog;
    const auto clip = dic_.clip_named(cell.clip);
    frame.cords[static_cast<std::size_t>(clip - dic_.clips.begin())].push_back(
        {cell.cord, lines[i]->from, pull * lines[i]->direction});
  }
  return {};
}

std::string FrameForces::add_tester(SessionFrame& frame, std::size_t number,
                                    const std::vector<HeldPlace>& held) const {
  const double force = log_.force[number];
  if (std::isnan(force)) return kBeyondLog;
  const auto add = [&](std::size_t c, const Eigen::Vector3d& by) {
    const Eigen::Vector3d middle = frame.positions(Eigen::all, held[c].edge).rowwise().mean();
    frame.cords[c].push_back({"", middle, by});
  };
  // What answers it is at the only other clip.
  add(pulled(), force * held[pulled()].outward);
  if (dic_.clips.size() == 2) add(1 - pulled(), -force * held[pulled()].outward);
  return {};
}

}  // namespace pliant
