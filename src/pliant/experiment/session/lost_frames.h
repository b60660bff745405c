#pragma once

#include <optional>
#include <vector>

#include "pliant/experiment/session/sheet_predictor.h"

namespace pliant {

/// Share of a test's frames that a fit or a prediction may lack: fewer tell another story.
inline constexpr double kLostShare = 0.25;

/// The frames of a prediction that have no equilibrium.
inline std::vector<int> lost_frames(const std::vector<std::optional<SheetShape>>& shapes) {
  std::vector<int> lost;
  for (std::size_t frame = 0; frame < shapes.size(); ++frame) {
    if (!shapes[frame]) lost.push_back(static_cast<int>(frame));
  }
  return lost;
}

}  // namespace pliant
