#include "pliant/material/kes_bending.h"

#include "pliant/base/assert.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/closed_loop.h"
#include "pliant/material/loop_reading.h"
#include "pliant/math/root.h"

namespace pliant {
namespace {

// The moment that the way back from the turn leaves over, counted in the sense of the side.
std::optional<double> residual(const LoopWays& loop, double side) {
  const auto moment = [&](double curvature) {
    return side > 0 ? loop.down(curvature) : -loop.up(-curvature);
  };
  constexpr double kSteps = 2000;
  if (moment(kKesLargestCurvature) <= 0) return std::nullopt;
  return first_root(moment, kKesLargestCurvature, -kKesLargestCurvature / kSteps, 0);
}

}  // namespace

KesBending kes_bending(const MaterialComponent& component) {
  PLIANT_ASSERT(component.stiffness.has_value(), "a component with numbers");
  const ClosedLoop closed(component, kStrainPerCurvature * kKesLargestCurvature);
  const LoopWays loop{
      [&](double curvature) { return closed.loading(kStrainPerCurvature * curvature); },
      [&](double curvature) { return closed.unloading(kStrainPerCurvature * curvature); }};
  KesBending result;
  result.rigidity = mean_slope(loop, kKesSlopeCurvature[0], kKesSlopeCurvature[1]);
  result.hysteresis = mean_width(loop, kKesHysteresisCurvature);
  const std::optional<double> right = residual(loop, 1), left = residual(loop, -1);
  if (right && left) result.residual_curvature = (*right + *left) / 2;
  return result;
}

}  // namespace pliant
