#include "pliant/experiment/profile/hanging_strip.h"

namespace pliant {

std::optional<HangingStrip> hanging_strip(std::initializer_list<const Elastica*> lines,
                                          const ComponentLaw& law, double rolled, double weight,
                                          bool with_derivatives, double accuracy) {
  for (const Elastica* line : lines) {
    StripHistory history = line->rolled(law, rolled);
    const auto shape = released(*line, law, weight, {}, with_derivatives, history, accuracy);
    if (!shape) return std::nullopt;
    if (!shape->jumps || line == *(lines.end() - 1)) return HangingStrip{*line, history, *shape};
  }
  return std::nullopt;
}

}  // namespace pliant
