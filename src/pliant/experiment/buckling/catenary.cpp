#include "pliant/experiment/buckling/catenary.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/math/root.h"

namespace pliant {

double catenary_pull(double weight, double length, double distance) {
  PLIANT_ASSERT(weight > 0 && distance > 0 && distance < length, "a strip that hangs");
  // With x = w d / (2 H), a monotone function: sinh(x) / x > 1 + x^2 / 6 bounds the root above.
  const double slack = length / distance - 1;
  const double bound = std::sqrt(6 * slack);
  const double x = root_in_bracket(
      [&](double at) { return at == 0 ? -slack : std::sinh(at) / at - 1 - slack; }, 0, bound);
  return weight * distance / (2 * x);
}

}  // namespace pliant
