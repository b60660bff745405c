#include "pliant/report/thinning.h"

#include <algorithm>
#include <numeric>

namespace pliant::report {

std::vector<std::size_t> thin_for_drawing(std::span<const double> values,
                                          std::span<const std::size_t> must_keep,
                                          std::size_t budget) {
  std::vector<std::size_t> kept;
  if (values.size() <= budget) {
    kept.resize(values.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    return kept;
  }
  if (must_keep.size() <= budget) kept.assign(must_keep.begin(), must_keep.end());
  kept.push_back(0);
  kept.push_back(values.size() - 1);
  const std::size_t stretches = std::max<std::size_t>(budget / 2, 1);
  for (std::size_t i = 0; i < stretches; ++i) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * values.size() / stretches);
    const auto end =
        values.begin() + static_cast<std::ptrdiff_t>((i + 1) * values.size() / stretches);
    const auto [low, high] = std::minmax_element(begin, end);
    kept.push_back(static_cast<std::size_t>(low - values.begin()));
    kept.push_back(static_cast<std::size_t>(high - values.begin()));
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

}  // namespace pliant::report
