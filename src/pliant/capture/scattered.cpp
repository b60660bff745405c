#include "pliant/capture/scattered.h"

#include <algorithm>
#include <cmath>

namespace pliant {

std::vector<int> scattered(int count, int wanted) {
  constexpr double kGolden = 0.6180339887498949;
  std::vector<int> numbers;
  for (int i = 1; i <= std::min(wanted, count); ++i) {
    const double share = kGolden * i - std::floor(kGolden * i);
    numbers.push_back(static_cast<int>(share * count));
  }
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

}  // namespace pliant
