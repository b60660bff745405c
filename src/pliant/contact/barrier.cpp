#include "pliant/contact/barrier.h"

#include <algorithm>
#include <cmath>

namespace pliant {

Barrier barrier(double distance, double thickness) {
  if (distance >= thickness) return {};
  const double half = thickness / 2;
  if (distance >= half) {
    const double depth = thickness - distance;
    return {depth * depth / 2, -depth, 1};
  }
  // At half the thickness value, slope and curvature of both are half^2 / 2, -half and 1.
  const double share = half / distance;
  return {half * half * (0.5 + std::log(share)), -half * share, share * share};
}

double distance_to_keep(double distance, double thickness, double share) {
  constexpr double kLeast = 1e-4, kOfLeast = 0.9;  // of the thickness; of a distance below that
  const double least = std::min(kLeast * thickness, kOfLeast * distance);
  return std::max(share * std::min(distance, thickness / 2), least);
}

}  // namespace pliant
