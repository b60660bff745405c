#include "pliant/material/material.h"

#include <vector>

namespace pliant {

std::string_view name_of(ComponentStatus status) {
  switch (status) {
    case ComponentStatus::measured:
      return "measured";
    case ComponentStatus::assumed:
      return "assumed";
    case ComponentStatus::unmeasured:
      return "unmeasured";
  }
  return "";
}

std::string_view name_of(MembraneMeasure measure) {
  switch (measure) {
    case MembraneMeasure::stvk:
      return "stvk";
    case MembraneMeasure::soft_constraint:
      return "soft-constraint";
    case MembraneMeasure::spring:
      return "spring";
  }
  return "";
}

MembraneMeasure membrane_measure(std::string_view name) {
  for (const MembraneMeasure measure :
       {MembraneMeasure::soft_constraint, MembraneMeasure::spring}) {
    if (name == name_of(measure)) return measure;
  }
  return MembraneMeasure::stvk;
}

bool is_bending(std::string_view component) { return component.substr(0, 5) == "bend."; }

bool is_even(std::string_view component) { return is_bending(component) || component == "shear"; }

const std::vector<std::string>& cloth_component_names() {
  static const std::vector<std::string> names{"stretch.weft", "stretch.warp", "stretch.bias",
                                              "shear",        "bend.weft",    "bend.warp",
                                              "bend.diagonal"};
  return names;
}

std::optional<ComponentLaw> law_of(const Material& material, const std::string& component) {
  const auto found = material.components.find(component);
  if (found == material.components.end() || !found->second.stiffness) return std::nullopt;
  ComponentLaw law;
  law.stiffness = *found->second.stiffness;
  if (found->second.friction) {
    const DahlParameters& dahl = found->second.friction->positive;
    law.friction_law = FrictionLaw::dahl;
    law.friction = {dahl.a, dahl.b, dahl.tau};
  }
  return law;
}

}  // namespace pliant
