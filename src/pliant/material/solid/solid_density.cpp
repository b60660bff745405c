#include "pliant/material/solid/solid_density.h"

#include <utility>

#include "pliant/base/assert.h"
#include "pliant/material/solid/metric_density.h"
#include "pliant/material/solid/pair_metric.h"
#include "pliant/material/solid/principal_density.h"

namespace pliant {

std::shared_ptr<const ParametricDensity> law_on_metric(
    const std::string& metric, std::shared_ptr<const ParametricDensity> law) {
  if (const StrainMetric* scalar = find_strain_metric(metric)) {
    return std::make_shared<MetricDensity>(*scalar, std::move(law));
  }
  if (const auto pair = find_pair_metric(metric)) {
    return std::make_shared<ScalarDensity<PairMetric>>(*pair, std::move(law));
  }
  const PrincipalMetric* principal = find_principal_metric(metric);
  PLIANT_ASSERT(principal, "components of solids are metrics");
  return std::make_shared<PrincipalDensity>(*principal, std::move(law));
}

NamedLaw solid_density(const Material& material, const DensityOptions& options) {
  PLIANT_ASSERT(material.kind == MaterialKind::solid, "a solid's law");
  ComponentSum sum(material);
  for (const std::string& name : ordered_components(material.components, material.kind)) {
    if (!material.components.at(name).stiffness) continue;
    DensityOptions own = options;
    if (find_principal_metric(name)) own.damping_fraction = 0;
    sum.add(name, /*strain=*/0, own,
            [&](std::shared_ptr<Sum> law) { return law_on_metric(name, std::move(law)); });
  }
  return std::move(sum).finish();
}

}  // namespace pliant
