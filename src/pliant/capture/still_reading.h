#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pliant {

/// What a cell read while the sample stood still around a frame (in the unit of its rows).
struct StillReading {
  double mean = 0;
  double spread = 0;  ///< standard deviation of the rows from a straight line through them
  double creep = 0;   ///< by which that line rises from the first row to the last
  double error = 0;   ///< standard deviation of the mean, by the spread alone
  /// Whether the line rises by more than the spread explains, and by what is not little.
  bool creeps = false;
};

/// @param times   of the rows, increasing (s)
/// @param middle  of the time in which it stood still (s)
/// @param still   how long that was (s)
/// @param largest  of all values, by their size: a hundredth of it is little
/// @return nothing of fewer than three rows, or of a time beside all rows
std::optional<StillReading> still_reading(const std::vector<double>& times,
                                          const std::vector<double>& values, double middle,
                                          double still, double largest);

/// How still forces were in a frame.
struct FrameStand {
  double spread = 0;  ///< of the rows of a cell (N), the largest
  std::string creep;  ///< what creeps, and by how much; or nothing
};

/// @param name  of what was read
FrameStand frame_stand(const StillReading& reading, const std::string& name);

}  // namespace pliant
