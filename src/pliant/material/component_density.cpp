#include "pliant/material/component_density.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/material/density/dahl_friction.h"
#include "pliant/material/density/damping.h"
#include "pliant/material/density/linearized_dahl_friction.h"
#include "pliant/material/density/stiffness_density.h"

namespace pliant {
namespace {

void add_names(const std::string& prefix, std::vector<std::string>& names) {
  for (const char* name : {"a", "b", "tau"}) names.push_back(prefix + name);
}

void add_addends(const std::string& component, const std::vector<Addend>& addends, int strain,
                 const DensityOptions& options, LawPart part, Sum& sum, AddedNames& names) {
  std::vector<Addend> added;
  std::ranges::copy_if(addends, std::back_inserter(added), [&](const Addend& addend) {
    const bool is_of_part =
        part == LawPart::all || (part == LawPart::elastic) == addend.is_elastic();
    return is_of_part && (options.friction || !addend.is_friction());
  });
  for (const std::string& name : parameter_names(added)) {
    names.parameters.push_back(component + "." + name);
  }
  for (std::size_t i = 0; i < added.size(); ++i) {
    for (int k = 0; k < added[i].history_size(); ++k) {
      names.history.push_back(
          fmt::format("{}.{}.{}.{}", added[i].kind().name, component, i + 1, k + 1));
    }
    sum.add_addend(added[i].kind().density(strain, added[i].values()));
  }
}

void add_friction(const std::string& component, const MaterialComponent& given, int strain,
                  const DensityOptions& options, Sum& sum, AddedNames& names) {
  if (!given.friction) return;
  names.history.push_back("friction." + component);
  const DahlBySide sides{given.friction->positive,
                         given.friction->negative.value_or(given.friction->positive)};
  if (options.friction_form == FrictionForm::linearized) {
    sum.add_addend(std::make_unique<LinearizedDahlFriction>(strain, sides));
  } else if (given.friction->negative) {
    sum.add_addend(std::make_unique<DahlFriction>(strain, sides));
    add_names(component + ".friction.positive.", names.parameters);
    add_names(component + ".friction.negative.", names.parameters);
  } else {
    sum.add_addend(std::make_unique<DahlFriction>(strain, sides.positive));
    add_names(component + ".friction.", names.parameters);
  }
}

// That at unit strain. Addends that stiffen without end are taken at the end of their range, or at
// rest; elastic ranges count whole.
double damped_stiffness(const MaterialComponent& component) {
  if (component.addends.empty()) return component.stiffness->value(1);
  const double end = component.range ? std::min(component.range->second, 1.0) : 0;
  const ComponentLaw law = law_of(component);
  return law.elastic_secant(end) + law.range_stiffness();
}

}  // namespace

AddedNames add_component(const Material& material, const std::string& component, int strain,
                         const DensityOptions& options, Sum& sum, LawPart part) {
  const auto found = material.components.find(component);
  PLIANT_ASSERT(found != material.components.end() && found->second.stiffness,
                "a component that was not measured has no law");
  const MaterialComponent& given = found->second;
  AddedNames names;
  if (part != LawPart::rest && given.stiffness->kind() != CurveKind::none) {
    names.parameters = parameter_names({*given.stiffness}, component);
    sum.add_addend(std::make_unique<StiffnessDensity>(strain, *given.stiffness));
  }
  if (part != LawPart::elastic && options.friction) {
    add_friction(component, given, strain, options, sum, names);
  }
  add_addends(component, given.addends, strain, options, part, sum, names);
  if (part != LawPart::elastic && options.damping_fraction > 0) {
    const double stiffness = damped_stiffness(given);
    sum.add_addend(std::make_unique<Damping>(strain, options.damping_fraction * stiffness));
  }
  return names;
}

}  // namespace pliant
