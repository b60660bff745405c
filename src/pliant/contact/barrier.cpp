#include "pliant/contact/barrier.h"

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

}  // namespace pliant
