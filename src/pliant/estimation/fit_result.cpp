#include "pliant/estimation/fit_result.h"

#include <algorithm>
#include <utility>

namespace pliant {

std::vector<int> SheetComparison::missing_frames() const {
  std::vector<int> missing;
  for (int frame = 0; frame < measured.frame_count(); ++frame) {
    if (!std::ranges::binary_search(frames, frame)) missing.push_back(frame);
  }
  return missing;
}

void add_starts(StartRecord starts, StudyResult& result) {
  const std::string alone = lone_start(starts);
  if (!alone.empty()) result.assumptions.push_back(alone);
  result.starts.push_back(std::move(starts));
}

}  // namespace pliant
