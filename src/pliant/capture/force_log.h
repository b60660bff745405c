#pragma once

#include <optional>
#include <vector>

#include "pliant/capture/dic_file.h"

namespace pliant {

/// What a tester's log says at each frame (SI).
struct FrameLog {
  std::vector<double> force;
  std::vector<double> extension;  ///< empty where the log has none
  std::vector<double> time;       ///< empty where it tells none
};

/// The log's rows, one a frame, or interpolated where the frames' rate is stated.
/// @throws InputError where rows and frames do not go together
FrameLog read_force_log(const DicForces& forces, int frames);

}  // namespace pliant
