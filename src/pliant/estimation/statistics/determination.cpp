#include "pliant/estimation/statistics/determination.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr double kSmallestShare = 0.1;  // of the scale: smaller values are near zero

}  // namespace

Determination determination_of(double value, double half_width, double scale) {
  const double share = half_width / std::max(std::abs(value), kSmallestShare * scale);
  if (share <= 0.1) return Determination::within_10_percent;
  if (share <= 0.3) return Determination::within_30_percent;
  return share <= 1 ? Determination::weak : Determination::none;
}

}  // namespace pliant
