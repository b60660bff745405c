#include "pliant/estimation/fit_result.h"

#include <algorithm>

namespace pliant {

std::vector<int> SheetComparison::missing_frames() const {
  std::vector<int> missing;
  for (int frame = 0; frame < measured.frame_count(); ++frame) {
    if (!std::ranges::binary_search(frames, frame)) missing.push_back(frame);
  }
  return missing;
}

}  // namespace pliant
