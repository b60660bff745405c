#include "pliant/material/material.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/assert.h"
#include "pliant/material/solid/metric.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/principal_metric.h"

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

std::string_view name_of(MaterialKind kind) {
  return kind == MaterialKind::solid ? "solid" : "cloth";
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

bool is_contraction(std::string_view component) { return component.starts_with("contraction."); }

LawUnits units_of(std::string_view component) {
  if (is_contraction(component)) return LawUnits::ratio;
  if (is_bending(component)) return LawUnits::bending;
  const bool solid = find_strain_metric(component) || find_principal_metric(component) ||
                     find_pair_metric(component);
  return solid ? LawUnits::solid : LawUnits::membrane;
}

bool is_even(std::string_view component) {
  const StrainMetric* metric = find_strain_metric(component);
  return is_bending(component) || component == "shear" || (metric && metric->even);
}

const std::vector<std::string>& cloth_component_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"stretch.weft", "stretch.warp", "stretch.bias", "shear"};
    for (const SheetMetric& metric : sheet_metrics()) all.emplace_back(metric.name);
    all.insert(all.end(), {"bend.weft", "bend.warp", "bend.diagonal"});
    all.insert(all.end(), {"contraction.weft", "contraction.warp", "contraction.bias"});
    return all;
  }();
  return names;
}

const std::vector<std::string>& solid_component_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const PrincipalMetric& metric : principal_metrics()) all.emplace_back(metric.name);
    for (const StrainMetric& metric : strain_metrics()) all.emplace_back(metric.name);
    return all;
  }();
  return names;
}

std::string limit_name(const std::vector<std::string>& components) {
  return fmt::format("{}.limit", fmt::join(components, "+"));
}

std::vector<std::string> limitable_components(MaterialKind kind) {
  if (kind == MaterialKind::solid) return solid_component_names();
  std::vector<std::string> names{"stretch.weft", "stretch.warp", "shear"};
  for (const SheetMetric& metric : sheet_metrics()) names.emplace_back(metric.name);
  return names;
}

Material of_constant_thickness(const Material& cloth) {
  Material solid;
  solid.name = cloth.name;
  solid.kind = MaterialKind::solid;
  for (const auto& [name, component] : cloth.components) {
    const std::string metric = solid_metric_of(name).value_or(green_strain_of(name));
    if (!metric.empty()) solid.components[metric] = component;
  }
  return solid;
}

const std::vector<std::string>& component_names(MaterialKind kind) {
  return kind == MaterialKind::solid ? solid_component_names() : cloth_component_names();
}

std::optional<std::string> pair_term_name(std::string_view component, MaterialKind kind) {
  if (kind == MaterialKind::cloth) return sheet_pair_name(component);
  const auto pair = find_pair_metric(component);
  return pair ? std::optional(pair->name()) : std::nullopt;
}

bool is_pair_term(std::string_view component, MaterialKind kind) {
  return pair_term_name(component, kind).has_value();
}

std::vector<std::string> ordered_components(
    const std::map<std::string, MaterialComponent>& components, MaterialKind kind) {
  std::vector<std::string> names;
  for (const std::string& name : component_names(kind)) {
    if (components.contains(name)) names.push_back(name);
  }
  for (const auto& [name, component] : components) {
    if (is_pair_term(name, kind)) names.push_back(name);
  }
  return names;
}

ComponentLaw law_of(const MaterialComponent& component) {
  PLIANT_ASSERT(component.stiffness.has_value(), "a component with numbers");
  ComponentLaw law;
  law.stiffness = *component.stiffness;
  law.addends = component.addends;
  if (component.friction) {
    const DahlParameters& dahl = component.friction->positive;
    law.friction_law = FrictionLaw::dahl;
    law.friction = {dahl.a, dahl.b, dahl.tau};
  }
  return law;
}

void set_law(MaterialComponent& component, const ComponentLaw& law) {
  component.stiffness = law.stiffness;
  component.addends = law.addends;
  component.friction.reset();
  if (law.friction_law != FrictionLaw::dahl) return;
  component.friction =
      ComponentFriction{{law.friction[0], law.friction[1], law.friction[2]}, std::nullopt};
}

MaterialComponent scaled(MaterialComponent component, double factor) {
  std::vector<double> values = component.stiffness->values();
  for (double& value : values) value *= factor;
  component.stiffness = component.stiffness->with_values(values.data());
  for (Addend& addend : component.addends) addend = addend.scaled(factor);
  component.errors.clear();
  if (!component.friction) return component;
  const auto scale = [&](DahlParameters& side) {
    side.a *= factor;
    side.b *= factor;
  };
  scale(component.friction->positive);
  if (component.friction->negative) scale(*component.friction->negative);
  return component;
}

std::optional<ComponentLaw> law_of(const Material& material, const std::string& component) {
  const auto found = material.components.find(component);
  if (found == material.components.end() || !found->second.stiffness) return std::nullopt;
  return law_of(found->second);
}

}  // namespace pliant
