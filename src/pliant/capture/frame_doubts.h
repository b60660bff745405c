#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/capture/dic_session.h"

namespace pliant {

/// Why a frame cannot be used whose cameras contradict each other; empty: they do not.
std::string contradiction_of(const std::optional<SightQuality>& quality);

/// A frame that the session has, and that is to be distrusted.
struct FrameDoubt {
  int frame = 0;
  std::string why;
};

/// Frames whose fixed tags say that a camera was moved, that hardly show the sample, whose matches
/// do not hold both ways, whose pictures are blurred or over-exposed, or in which a force creeps.
std::vector<FrameDoubt> frame_doubts(const DicSession& made);

}  // namespace pliant
