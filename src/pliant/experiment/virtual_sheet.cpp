#include "pliant/experiment/virtual_sheet.h"

#include <cmath>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/material/fill.h"
#include "pliant/material/positive_stiffness.h"

namespace pliant {
namespace {

Material varied(Material material, double variation, RandomStream random) {
  const auto vary = [&](double value) { return value * std::exp(variation * random.normal()); };
  const auto vary_friction = [&](DahlParameters& dahl) {
    dahl = {vary(dahl.a), vary(dahl.b), vary(dahl.tau)};
  };
  for (auto& [name, component] : material.components) {
    if (!component.stiffness) continue;
    std::vector<double> values = component.stiffness->values();
    for (double& value : values) value = vary(value);
    component.stiffness = component.stiffness->with_values(values.data());
    for (Addend& addend : component.addends) {
      addend = Addend(addend.kind(), addend.values().unaryExpr(vary));
    }
    if (!component.friction) continue;
    vary_friction(component.friction->positive);
    if (component.friction->negative) vary_friction(*component.friction->negative);
  }
  return material;
}

}  // namespace

Material sheet_of(const VirtualSpecimen& specimen) {
  if (specimen.variation == 0) return specimen.material;
  return varied(specimen.material, specimen.variation,
                specimen.random.split(fmt::format("sheet {}", specimen.number)));
}

void require_whole_sheet(const Material& material, const Location& where) {
  for (const std::string& component : sheet_component_names()) {
    if (is_known(material, component)) continue;
    throw InputError(where,
                     "needs a component that the material " + quoted_value(material.name) +
                         " does not have: " + component,
                     "a material with stretch, shear and bending in all directions");
  }
  require_positive_stiffness(material, sheet_component_names(), where);
  if (!(material.density > 0)) {
    throw InputError(where,
                     "needs the density of the material " + quoted_value(material.name) +
                         ", which does not say it",
                     "a material with `density`: gravity acts in every test");
  }
}

}  // namespace pliant
