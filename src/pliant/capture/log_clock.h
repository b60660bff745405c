#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pliant {

/// When the first frame was taken, by the clock of a tester's log.
struct LogClock {
  double start = 0, error = 0;  ///< s, and its standard deviation
  double correlation = 0;       ///< of both motions
};

/// A clock, or why there is none.
struct ClockSearch {
  std::optional<LogClock> clock;
  std::string why;
};

/// Finds the time at which what cameras saw of a clip's way and the log's extension go together:
/// ways = offset + gain extension(start + frame / rate), by least squares. A motion that turns,
/// starts or stops tells it; a steady one does not.
/// @param times, extension  of the log, times increasing (s; m)
/// @param ways  of the clip in each frame, NaN where it was not seen (m)
/// @param rate  of the frames (1/s)
ClockSearch find_clock(const std::vector<double>& times, const std::vector<double>& extension,
                       const std::vector<double>& ways, double rate);

}  // namespace pliant
