#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "pliant/material/density/dahl.h"

namespace pliant::test {

/// d stress / d strain at (strain, stress) for one sign of the strain rate.
using StressRate = std::function<double(double strain, double stress, double sign)>;

/// The classical Runge-Kutta method on one side of zero strain, `step` at most a stretch's length.
inline double integrate_on_one_side(const StressRate& rate, FrictionState from, double strain,
                                    double step) {
  const double sign = strain < from.strain ? -1 : 1;
  const int steps = std::max(1, static_cast<int>(std::abs(strain - from.strain) / step) + 1);
  const double h = (strain - from.strain) / steps;
  double x = from.strain, y = from.stress;
  for (int i = 0; i < steps; ++i, x += h) {
    const double k1 = rate(x, y, sign);
    const double k2 = rate(x + h / 2, y + h / 2 * k1, sign);
    const double k3 = rate(x + h / 2, y + h / 2 * k2, sign);
    const double k4 = rate(x + h, y + h * k3, sign);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return y;
}

/// Friction stress at `strain` by numerical integration; |strain| has a kink at zero, so the path
/// is split there to keep the method's order.
inline double integrate_friction(const StressRate& rate, const FrictionState& from, double strain,
                                 double step) {
  if (from.strain * strain >= 0) return integrate_on_one_side(rate, from, strain, step);
  const double at_zero = integrate_on_one_side(rate, from, 0, step);
  return integrate_on_one_side(rate, {0, at_zero}, strain, step);
}

}  // namespace pliant::test
