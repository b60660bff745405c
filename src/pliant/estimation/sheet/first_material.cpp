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

}  // namespace pliant
