#pragma once

#include <vector>

#include "pliant/capture/dic_file.h"

namespace pliant {

/// What a tester's log says at each frame (SI).
struct FrameLog {
  std::vector<double> force;      ///< NaN of frames that the log does not cover (`start`)
  std::vector<double> extension;  ///< likewise; empty where the log has none
  std::vector<double> time;       ///< by the log's clock; empty where it tells none
};

/// The log's rows as they stand.
/// @throws InputError
FrameLog read_log_rows(const DicForces& forces);

/// The log's rows, one a frame, or interpolated where the frames' rate is stated.
/// @param start  of the first frame by the log's clock (s), with a rate
/// @throws InputError where rows and frames do not go together
FrameLog log_of_frames(FrameLog rows, const DicForces& forces, int frames, double start);

}  // namespace pliant
