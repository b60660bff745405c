#include "pliant/experiment/row_times.h"

#include <algorithm>

#include <fmt/format.h>

namespace pliant {

void require_times(const Experiment& experiment, const Location& where) {
  const ExperimentInfo& info = experiment.info();
  const auto refuse = [&](const std::string& problem, const char* expected) {
    throw InputError(
        where,
        fmt::format("asks for what flows with time, and {} {}", quoted_value(info.name), problem),
        expected);
  };
  if (!info.test.follows_time) {
    refuse(fmt::format("is of the test {}, which follows no time", info.type),
           "tests in which a machine imposes the strain, or laws without time");
  }
  if (info.time.empty()) {
    refuse("does not tell when its rows were measured", "a column of the time, e.g. `time_s`");
  }
  for (const std::vector<int>& rows : experiment.series()) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const auto time = [&](std::size_t k) { return info.time[static_cast<std::size_t>(rows[k])]; };
      if (time(i) >= time(i - 1)) continue;
      refuse(fmt::format("goes back in time, from {} to {} s at row {}", time(i - 1), time(i),
                         rows[i] + 1),
             "times that grow from row to row");
    }
  }
}

double duration_of(const ExperimentInfo& info) {
  if (info.time.empty()) return 0;
  const auto [first, last] = std::ranges::minmax(info.time);
  return last - first;
}

}  // namespace pliant
