#include "pliant/material/kes_shear.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/material/closed_loop.h"

namespace pliant {

KesShear kes_shear(const LoopWays& loop) {
  return {mean_slope(loop, kKesSlopeAngle[0], kKesSlopeAngle[1]),
          mean_width(loop, kKesHysteresisAngle[0]), mean_width(loop, kKesHysteresisAngle[1])};
}

KesShear kes_shear(const MaterialComponent& component) {
  PLIANT_ASSERT(component.stiffness.has_value(), "a component with numbers");
  const ClosedLoop closed(component, std::sin(kKesLargestAngle));
  return kes_shear(LoopWays{[&](double angle) { return closed.loading(std::sin(angle)); },
                            [&](double angle) { return closed.unloading(std::sin(angle)); }});
}

}  // namespace pliant
