#include "pliant/material/use_warnings.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/plausibility.h"
#include "pliant/material/fill.h"

namespace pliant {

std::vector<std::string> use_warnings(const Material& material, std::span<const std::string> used) {
  std::vector<std::string> warnings;
  const std::string name = quoted_value(material.name);
  if (material.density > 0) {
    Plausibility cloth;
    cloth.add(figures::kAreaDensity, material.density,
              {{cloth.column("density", Dimension::area_density, "kg/m^2")}});
    if (const auto question = cloth.question()) {
      warnings.push_back(fmt::format("the material {}: {}", name, *question));
    }
  }
  std::vector<std::string> unused;
  for (const auto& [component, given] : material.components) {
    if (given.status != ComponentStatus::measured || !is_known(material, component)) continue;
    if (std::find(used.begin(), used.end(), component) == used.end()) unused.push_back(component);
  }
  if (!unused.empty()) {
    warnings.push_back(fmt::format("{} of {} {} measured, but the simulation of a sheet uses {}",
                                   fmt::join(unused, ", "), name,
                                   unused.size() == 1 ? "was" : "were", fmt::join(used, ", ")));
  }
  return warnings;
}

}  // namespace pliant
