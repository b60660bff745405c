#include "pliant/material/component_density.h"

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

}  // namespace

AddedNames add_component(const Material& material, const std::string& component, int strain,
                         const DensityOptions& options, Sum& sum) {
  const auto found = material.components.find(component);
  PLIANT_ASSERT(found != material.components.end() && found->second.stiffness,
                "a component that was not measured has no law");
  const MaterialComponent& given = found->second;
  ComponentLaw elastic{*given.stiffness, FrictionLaw::none, {}};
  AddedNames names{parameter_names(elastic, component), {}};
  sum.add_addend(std::make_unique<StiffnessDensity>(strain, *given.stiffness));

  if (given.friction && options.friction) {
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
  if (options.damping_fraction > 0) {
    const double stiffness = given.stiffness->value(1);
    sum.add_addend(std::make_unique<Damping>(strain, options.damping_fraction * stiffness));
  }
  return names;
}

}  // namespace pliant
