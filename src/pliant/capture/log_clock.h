#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pliant {

/// When the first frame was taken, by the clock of a log.
struct LogClock {
  double start = 0, error = 0;  ///< s, and its standard deviation
  double correlation = 0;       ///< of both motions
};

/// A clock, or why there is none.
struct ClockSearch {
  std::optional<LogClock> clock;
  std::string why;
};

/// What a log tells of a motion.
struct ClockLog {
  std::vector<double> time;   ///< increasing (s)
  std::vector<double> value;  ///< extension (m) or force (N)
  bool goes_straight = true;  ///< ways go with it by a straight line, as with an extension, or by a
                              ///< parabola, as with a force
  double still = 0;           ///< how long nothing moves around a frame (s); 0: not known
};

/// Finds the time at which what cameras saw of a way and what the log tells go together:
/// ways = offset + gain value(start + frame / rate), and for a force a term of its square, by least
/// squares. A motion that turns, starts or stops tells it; a steady one does not. Of one that goes
/// in steps, which fits as well anywhere on them, it is the middle.
/// @param ways  in each frame, NaN where they were not seen (m)
/// @param rate  of the frames (1/s)
ClockSearch find_clock(const ClockLog& log, const std::vector<double>& ways, double rate);

}  // namespace pliant
