#include "pliant/report/frame_choice.h"

#include <algorithm>

namespace pliant::report {

std::vector<int> evenly_chosen(int count, int most) {
  const int chosen = std::min(count, most);
  std::vector<int> frames;
  for (int i = 0; i < chosen; ++i) {
    frames.push_back(chosen > 1 ? i * (count - 1) / (chosen - 1) : 0);
  }
  return frames;
}

}  // namespace pliant::report
