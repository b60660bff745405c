#include "pliant/estimation/sheet/first_material.h"

#include <algorithm>

#include "pliant/estimation/sheet/sheet_options.h"

namespace pliant {

Material first_sheet_material(const FitSettings& settings, const KnownComponents& known) {
  Material material;
  material.name = settings.name;
  material.density = settings.density;
  material.membrane = settings.model.membrane;
  material.bending = settings.model.bending;
  const bool bends =
      std::ranges::any_of(known, [](const auto& component) { return is_bending(component.first); });
  material.bending_of = bends ? "sheet" : "hinges";
  const bool springs = material.bending == "spring";
  const auto give = [&](const char* component, double stiffness) {
    material.components[component].stiffness = ScalarCurve::hermite(
        {0.0}, {fixed_stiffness(settings.fit, {component}).value_or(stiffness)},
        is_even(component));
  };
  for (const char* component : {"stretch.weft", "stretch.warp"}) give(component, 100);
  give("shear", 20);
  for (const char* component : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    give(component, springs ? 0.1 : 3e-6);
  }
  for (const auto& [component, law] : known) material.components[component] = law;
  return material;
}

std::vector<double> first_bending(const Material& material, const ComponentGroup& group) {
  const auto known = [&](const char* component) {
    return material.components.at(component).stiffness->value(0);
  };
  std::vector<double> values;
  if (group.front() == "bend.diagonal") {
    const double mean = (known("bend.weft") + known("bend.warp")) / 2;
    for (const double share : {2.0, 1.0, 0.5, 0.25}) values.push_back(share * mean);
    return values;
  }
  const bool springs = material.bending == "spring";
  for (double value = springs ? 0.1 : 1e-3; value > (springs ? 1e-4 : 3e-8); value *= 0.4) {
    values.push_back(value);
  }
  return values;
}

}  // namespace pliant
