#include "pliant/material/use_warnings.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/number_with_error.h"
#include "pliant/base/plausibility.h"
#include "pliant/material/fill.h"

namespace pliant {
namespace {

bool is_friction(const std::string& number) { return number.starts_with("friction."); }

/// None of the numbers of the stiffness and the addends, or none of friction, is told by the data;
/// one at its bound is.
bool is_undetermined(const MaterialComponent& component, bool friction) {
  bool any = false;
  for (const auto& [number, error] : component.errors) {
    if (is_friction(number) != friction) continue;
    if (error.determined != Determination::none || error.limit) return false;
    any = true;
  }
  return any;
}

/// "k1 180 +- 400" of a number of a component.
std::vector<std::string> numbers_with_errors(const MaterialComponent& component, bool friction) {
  const ComponentLaw law = law_of(component);
  const std::vector<std::string> names = parameter_names(law, "");
  const Eigen::VectorXd values = law.parameters();
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string number = names[i].substr(1);
    const auto error = component.errors.find(number);
    if (error == component.errors.end() || is_friction(number) != friction) continue;
    const auto sd = error->second.std_error;
    const double value = values(static_cast<Eigen::Index>(i));
    texts.push_back(number + " " +
                    (sd && *sd > 0 ? number_with_error(value, *sd)
                                   : format_number(value, 3) + " +- any number"));
  }
  return texts;
}

}  // namespace

std::vector<std::string> undetermined_warnings(const Material& material,
                                               std::span<const std::string> used) {
  std::vector<std::string> warnings;
  for (const auto& [name, component] : material.components) {
    if (std::ranges::find(used, name) == used.end() || !is_known(material, name)) continue;
    for (const bool friction : {false, true}) {
      if (!is_undetermined(component, friction)) continue;
      warnings.push_back(fmt::format(
          "{} of {} in {} is not determined by the data that it was fitted to ({}): what hangs on "
          "it is a guess",
          friction ? "friction" : "the stiffness", name, quoted_value(material.name),
          fmt::join(numbers_with_errors(component, friction), ", ")));
    }
  }
  return warnings;
}

std::vector<std::string> use_warnings(const Material& material, std::span<const std::string> used) {
  std::vector<std::string> warnings = undetermined_warnings(material, used);
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
