#include "pliant/scene/keyframes.h"

#include <algorithm>

#include "pliant/base/assert.h"

namespace pliant {

KeyframePlace place_among(const std::vector<double>& times, Interpolation interpolation,
                          double time) {
  PLIANT_ASSERT(!times.empty(), "at least one keyframe");
  if (time <= times.front()) return {};
  const auto next = std::upper_bound(times.begin(), times.end(), time);
  const int before = static_cast<int>(next - times.begin()) - 1;
  if (next == times.end()) return {before, 0};
  const double start = *(next - 1);
  const double s = (time - start) / (*next - start);
  return {before, interpolation == Interpolation::smooth ? s * s * (3 - 2 * s) : s};
}

Eigen::Vector3d value_at(const KeyframedVector& vector, double time) {
  PLIANT_ASSERT(vector.values.size() == vector.times.size(), "one value for each time");
  const auto [before, fraction] = place_among(vector.times, vector.interpolation, time);
  const auto i = static_cast<std::size_t>(before);
  if (fraction == 0) return vector.values[i];
  return vector.values[i] + fraction * (vector.values[i + 1] - vector.values[i]);
}

}  // namespace pliant
