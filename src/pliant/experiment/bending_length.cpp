#include "pliant/experiment/bending_length.h"

#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/base/quantity.h"
#include "pliant/math/root.h"
#include "pliant/solver/elastica/strip_release.h"

namespace pliant {
namespace {

constexpr double kShortest = 1e-3;  // m; no sheet dips far in that
constexpr double kLongest = 10;
constexpr double kGrowth = 1.25;  // of the length, from one trial to the next

// Angle (rad) by which the tip of a strip of some length lies below its edge.
std::optional<double> dip(const ComponentLaw& law, double weight, double length) {
  const Elastica strip(length);
  StripHistory history = strip.rested(law);
  const auto shape = released(strip, law, weight, {}, false, history);
  if (!shape) return std::nullopt;
  const Eigen::Vector2d tip = strip.profile({}, *shape).at(length).position;
  return std::atan2(-tip.y(), tip.x());
}

}  // namespace

std::optional<BendingLength> bending_length(const ComponentLaw& law, double area_density,
                                            double angle) {
  PLIANT_ASSERT(area_density > 0, "its own weight bends the strip");
  PLIANT_ASSERT(angle > 0 && angle < std::numbers::pi / 2, "the tip lies below the edge");
  const double weight = area_density * kStandardGravity;
  double below = 0;
  for (double length = kShortest; length < kLongest; length *= kGrowth) {
    const std::optional<double> here = dip(law, weight, length);
    if (!here) return std::nullopt;
    if (*here < angle) {
      below = length;
      continue;
    }
    if (below == 0) return std::nullopt;
    BendingLength result;
    result.overhang = root_in_bracket(
        [&](double trial) { return dip(law, weight, trial).value_or(*here) - angle; }, below,
        length);
    result.length = result.overhang / 2;
    result.flexural_rigidity = weight * std::pow(result.length, 3);
    return result;
  }
  return std::nullopt;
}

}  // namespace pliant
