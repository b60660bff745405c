#include "pliant/capture/line_through_rows.h"

#include <algorithm>
#include <cstddef>

namespace pliant {

LinePiece line_at(const std::vector<double>& at, const std::vector<double>& values, double place) {
  const auto after = std::ranges::upper_bound(at, place);
  const auto row = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - at.begin(), 1, std::ssize(at) - 1));
  const double slope = (values[row] - values[row - 1]) / (at[row] - at[row - 1]);
  if (place == at[row - 1]) return {values[row - 1], slope};  // though the next one be NaN
  if (place == at[row]) return {values[row], slope};
  return {values[row - 1] + slope * (place - at[row - 1]), slope};
}

}  // namespace pliant
