#include "pliant/experiment/experiment_spec.h"

namespace pliant {

bool is_supported_type(std::string_view type) {
  return type == "hanging-weights" || type == "tensile-cycles" || type == "shear-cycles" ||
         type == "pure-bending" || type == "buckling-bend" || bends_by_weight(type);
}

std::string_view name_of(BucklingSide side) { return side == BucklingSide::up ? "up" : "down"; }

bool measures_profiles(std::string_view type) {
  return type == "cantilever" || type == "rolled-strip";
}

bool overhangs(std::string_view type) { return type == "cantilever" || type == "bending-length"; }

bool bends_by_weight(std::string_view type) {
  return type == "bending-length" || measures_profiles(type);
}

bool measures_sheets(std::string_view type) { return type == "session"; }

bool needs_density(std::string_view type) {
  return type == "buckling-bend" || bends_by_weight(type);
}

std::string component_of_test(std::string_view type, const std::string& direction) {
  if (type == "shear-cycles") return "shear";
  const bool bends = type == "pure-bending" || type == "buckling-bend" || bends_by_weight(type);
  if (!bends) {
    const bool oblique = direction != "warp" && direction != "weft" && direction != "bias";
    return oblique ? "shear" : "stretch." + direction;
  }
  return "bend." + (direction == "bias" ? "diagonal" : direction);
}

}  // namespace pliant
