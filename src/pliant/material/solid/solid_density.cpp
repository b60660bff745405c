#include "pliant/material/solid/solid_density.h"

#include <iterator>

#include "pliant/base/assert.h"
#include "pliant/material/solid/metric_density.h"
#include "pliant/material/solid/principal_density.h"

namespace pliant {
namespace {

std::shared_ptr<const ParametricDensity> on_metric(const std::string& component,
                                                   std::shared_ptr<const Sum> law) {
  if (const StrainMetric* metric = find_strain_metric(component)) {
    return std::make_shared<MetricDensity>(*metric, std::move(law));
  }
  const PrincipalMetric* metric = find_principal_metric(component);
  PLIANT_ASSERT(metric, "components of solids are metrics");
  return std::make_shared<PrincipalDensity>(*metric, std::move(law));
}

}  // namespace

SolidDensity solid_density(const Material& material, const DensityOptions& options) {
  PLIANT_ASSERT(material.kind == MaterialKind::solid, "a solid's law");
  SolidDensity result{std::make_shared<Sum>(), {}};
  for (const std::string& name : solid_component_names()) {
    const auto found = material.components.find(name);
    if (found == material.components.end() || !found->second.stiffness) continue;
    DensityOptions own = options;
    if (find_principal_metric(name)) own.damping_fraction = 0;
    const auto law = std::make_shared<Sum>();
    AddedNames names = add_component(material, name, /*strain=*/0, own, *law);
    std::ranges::move(names.parameters, std::back_inserter(result.names.parameters));
    std::ranges::move(names.history, std::back_inserter(result.names.history));
    result.law->add_addend(on_metric(name, law));
  }
  return result;
}

}  // namespace pliant
