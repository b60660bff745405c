#include "pliant/capture/logged_forces.h"

#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {

void LoggedForces::place_by_stated_start() {
  if (needs_clock_) return;
  place(forces().start ? forces().start->time.value_or(0) : 0);
}

bool LoggedForces::is_beyond(std::size_t frame, const std::vector<double>& times) const {
  if (!forces().rate) return false;
  return log_.time[frame] < times.front() || log_.time[frame] > times.back();
}

std::vector<double> LoggedForces::by_moment(const std::vector<double>& of_frames) const {
  std::vector<double> all(static_cast<std::size_t>(moments_.back()) + 1,
                          std::numeric_limits<double>::quiet_NaN());
  for (std::size_t f = 0; f < of_frames.size(); ++f) {
    all[static_cast<std::size_t>(moments_[f])] = of_frames[f];
  }
  return all;
}

std::string LoggedForces::find_clock(const std::vector<double>& ways) {
  const Together both = together(ways);
  const ClockSearch search = pliant::find_clock(both.log, by_moment(both.ways), *forces().rate);
  if (!search.clock) {
    throw InputError(forces().start->where, "is not found: " + search.why, kStatedStart);
  }
  needs_clock_ = false;
  place(search.clock->start);
  return fmt::format(
      "by {} the first frame was taken at {:.4g} s of the log, to {:.2g} s (they go together by "
      "{:.5f})",
      both.by, search.clock->start, search.clock->error, search.clock->correlation);
}

}  // namespace pliant
