#include "pliant/estimation/sheet/sheet_unknown.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

void add_unknowns(const ComponentLaw& law, const ComponentGroup& group, double strain,
                  std::vector<SheetUnknown>& unknowns) {
  const std::vector<std::string> names = parameter_names(law, group.front());
  const std::vector<std::string> units = parameter_units(law, is_bending(group.front()));
  const std::vector<double>& knots = law.stiffness.knots();
  const std::vector<double>& values = law.stiffness.values();
  const double stiffness = std::max(*std::ranges::max_element(values), 1e-12);
  for (std::size_t i = 0; i < names.size(); ++i) {
    SheetUnknown unknown;
    unknown.name = names[i];
    unknown.owner = group.front();
    unknown.unit = units[i];
    unknown.upper = kNoLimit;
    unknown.scale = stiffness;
    unknown.of_friction = i >= values.size();
    if (i < knots.size()) unknown.strain = knots[i];
    if (names[i].ends_with(".a")) unknown.scale = stiffness * strain / 10;
    if (names[i].ends_with(".tau")) {
      unknown.scale = strain / 10;
      unknown.lower = strain / 1000;
      unknown.upper = 3 * strain;
    }
    for (const std::string& component : group) {
      unknown.parameters.push_back(component + names[i].substr(group.front().size()));
    }
    unknowns.push_back(std::move(unknown));
  }
}

/// Springs of the second ring have a stiffness in N, as their energy is per length. They resist
/// stretch as well, by their stiffness over a cell, and must leave most of it to the first ring.
void limit_bending_springs(const Material& material, double cell,
                           std::vector<SheetUnknown>& unknowns) {
  constexpr double kShare = 0.1;
  double stretch = INFINITY;
  for (const char* component : {"stretch.weft", "stretch.warp"}) {
    const std::vector<double>& values = material.components.at(component).stiffness->values();
    stretch = std::min(stretch, *std::ranges::max_element(values));
  }
  for (SheetUnknown& unknown : unknowns) {
    if (!is_bending(unknown.owner) || unknown.of_friction) continue;
    unknown.unit = std::string(1, 'N');
    unknown.upper = std::max(kShare * stretch * cell, 1e-9);
  }
}

}  // namespace

ComponentLaw law_of(const Material& material, const ComponentGroup& group) {
  const std::optional<ComponentLaw> law = law_of(material, group.front());
  PLIANT_ASSERT(law.has_value(), "a fit begins with a complete material");
  return *law;
}

void set_law(Material& material, const ComponentGroup& group, const ComponentLaw& law) {
  for (const std::string& name : group) {
    MaterialComponent& component = material.components[name];
    component.stiffness = law.stiffness;
    component.friction.reset();
    if (law.friction_law == FrictionLaw::none) continue;
    component.friction =
        ComponentFriction{{law.friction[0], law.friction[1], law.friction[2]}, std::nullopt};
  }
}

std::vector<SheetUnknown> unknowns_of(const Material& material,
                                      const std::vector<ComponentGroup>& groups,
                                      const std::vector<double>& strains, double cell) {
  PLIANT_ASSERT(strains.size() == groups.size(), "a strain for each group");
  std::vector<SheetUnknown> unknowns;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    add_unknowns(law_of(material, groups[g]), groups[g], strains[g], unknowns);
  }
  if (material.bending == "spring") limit_bending_springs(material, cell, unknowns);
  return unknowns;
}

Eigen::VectorXd values_of(const Material& material, const std::vector<ComponentGroup>& groups) {
  Eigen::VectorXd values;
  for (const ComponentGroup& group : groups) {
    const Eigen::VectorXd own = law_of(material, group).parameters();
    values.conservativeResize(values.size() + own.size());
    values.tail(own.size()) = own;
  }
  return values;
}

void set_values(Material& material, const std::vector<ComponentGroup>& groups,
                const Eigen::VectorXd& values) {
  Eigen::Index next = 0;
  for (const ComponentGroup& group : groups) {
    const ComponentLaw law = law_of(material, group);
    set_law(material, group, law.with_parameters(values.segment(next, law.parameter_count())));
    next += law.parameter_count();
  }
}

}  // namespace pliant
