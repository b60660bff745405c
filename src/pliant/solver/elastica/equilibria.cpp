#include "pliant/solver/elastica/equilibria.h"

#include <algorithm>
#include <cmath>

namespace pliant {

std::vector<StripShape> equilibria_near(const Elastica& strip, const ComponentLaw& law,
                                        double weight, const StripEnds& ends,
                                        const StripHistory& history, const StripShape& near,
                                        double reach) {
  constexpr double kStep = 0.75, kSame = 1e-6;  // rad
  const auto tip_angle = [&](const StripShape& shape) {
    return strip.line().weights().dot(shape.curvature);
  };
  std::vector<StripShape> found;
  const int each_way = std::max(static_cast<int>(std::ceil(reach / kStep)), 1);
  for (int step = -each_way; step <= each_way; ++step) {
    StripShape guess = near;
    guess.curvature.array() += reach * step / each_way / strip.line().length();
    const auto shape = strip.equilibrium(law, weight, ends, history, guess);
    if (!shape || !strip.is_stable(law, weight, ends, history, *shape)) continue;
    const bool known = std::any_of(found.begin(), found.end(), [&](const StripShape& other) {
      return std::abs(tip_angle(other) - tip_angle(*shape)) < kSame;
    });
    if (!known) found.push_back(*shape);
  }
  std::sort(found.begin(), found.end(),
            [&](const StripShape& a, const StripShape& b) { return tip_angle(a) < tip_angle(b); });
  return found;
}

}  // namespace pliant
