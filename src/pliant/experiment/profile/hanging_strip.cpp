#include "pliant/experiment/profile/hanging_strip.h"

#include <algorithm>
#include <cmath>

#include "pliant/material/bending_strain.h"
#include "pliant/material/snapping_strains.h"

namespace pliant {

bool snaps(const ComponentLaw& law, double curvature) {
  const double strain = kStrainPerCurvature * std::abs(curvature);
  return std::ranges::any_of(snapping_strains(law, 1, strain), [&](const StrainInterval& snapping) {
    return snapping.from < strain && strain <= snapping.to;
  });
}

std::optional<HangingStrip> hanging_strip(std::initializer_list<const Elastica*> lines,
                                          const ComponentLaw& law, double rolled, double weight,
                                          bool with_derivatives, double accuracy) {
  const bool jumps = snaps(law, rolled);
  for (const Elastica* line : lines) {
    if (jumps && line != *(lines.end() - 1)) continue;
    StripHistory history = line->rolled(law, rolled);
    const auto shape = released(*line, law, weight, {}, with_derivatives, history, accuracy);
    if (!shape) return std::nullopt;
    if (!shape->jumps || line == *(lines.end() - 1)) return HangingStrip{*line, history, *shape};
  }
  return std::nullopt;
}

}  // namespace pliant
