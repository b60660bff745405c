#include "pliant/experiment/row_times.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

namespace pliant {
namespace {

/// Why an experiment cannot be followed in time, and what could be.
struct TimeProblem {
  std::string problem;
  const char* expected;
};

std::optional<TimeProblem> time_problem(const Experiment& experiment) {
  const ExperimentInfo& info = experiment.info();
  if (!info.test.follows_time) {
    return TimeProblem{fmt::format("is of the test {}, which follows no time", info.type),
                       "tests in which a machine imposes the strain, or laws without time"};
  }
  if (info.time.empty()) {
    return TimeProblem{"does not tell when its rows were measured",
                       "a column of the time, e.g. `time_s`"};
  }
  for (const std::vector<int>& rows : experiment.series()) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const auto time = [&](std::size_t k) { return info.time[static_cast<std::size_t>(rows[k])]; };
      if (time(i) >= time(i - 1)) continue;
      return TimeProblem{fmt::format("goes back in time, from {} to {} s at row {}", time(i - 1),
                                     time(i), rows[i] + 1),
                         "times that grow from row to row"};
    }
  }
  return std::nullopt;
}

}  // namespace

bool has_times(const Experiment& experiment) { return !time_problem(experiment); }

void require_times(const Experiment& experiment, const Location& where) {
  const auto found = time_problem(experiment);
  if (!found) return;
  throw InputError(where,
                   fmt::format("asks for what flows with time, and {} {}",
                               quoted_value(experiment.info().name), found->problem),
                   found->expected);
}

double duration_of(const ExperimentInfo& info) {
  if (info.time.empty()) return 0;
  const auto [first, last] = std::ranges::minmax(info.time);
  return last - first;
}

}  // namespace pliant
